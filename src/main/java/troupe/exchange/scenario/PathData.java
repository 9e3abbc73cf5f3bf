package troupe.exchange.scenario;

import java.util.Arrays;
import troupe.exchange.format.ExchangeException;

/**
 * Reads the outline of a path of SVG: commands M, L, H, V, C and Z, absolute and relative, cubic curves
 * flattened so that no point of a curve is farther than {@value #FLATNESS} units from the corners' outline.
 * One closed outline is taken, and at most {@value #MAX_CORNERS} corners; corners that repeat the one before
 * within {@value #SAME} units are left out, the closing corner too.
 *
 * <p>Source: SVG 1.1, section 8.3; the number of pieces of a curve from the bound of its second differences
 * (Wang; Farin, Curves and Surfaces for CAGD).
 */
final class PathData {
    static final double FLATNESS = 0.01;
    static final double SAME = 1e-4;
    static final int MAX_CORNERS = 10_000;

    private final String text;
    private final Fault fault;
    private int at;
    private double x;
    private double y;
    private double[] corners = new double[32];
    private int count;
    private boolean closed;

    /** Makes the report of a mistake of the path; whoever reads it knows file and line. */
    @FunctionalInterface
    interface Fault {
        /** Returns the exception with what was expected and found, and what to do. */
        ExchangeException of(String wrong, String cure);
    }

    private PathData(String text, Fault fault) {
        this.text = text;
        this.fault = fault;
    }

    /**
     * Reads the outline of a path as {@code x0, y0, x1, y1, …} in the units of the drawing, y down. It may have
     * fewer than three corners. Cost O(text + corners).
     *
     * @throws ExchangeException if the text is no path, holds another command, or more than one outline
     */
    static double[] read(String text, Fault fault) throws ExchangeException {
        PathData path = new PathData(text, fault);
        path.commands();
        return path.outline();
    }

    private void commands() throws ExchangeException {
        if (Character.toUpperCase(peek()) != 'M') {
            throw found("a path begins with M or m");
        }
        char command = text.charAt(at++) == 'M' ? 'L' : 'l';
        line(number(), number());
        for (char next = peek(); next != 0; next = peek()) {
            if (Character.isLetter(next)) {
                command = next;
                at++;
            } else if (closed || "+-.0123456789".indexOf(next) < 0) {
                throw found("give a command or a number");
            }
            draw(command);
        }
    }

    private void draw(char command) throws ExchangeException {
        double fromX = Character.isLowerCase(command) ? x : 0;
        double fromY = Character.isLowerCase(command) ? y : 0;
        if (Character.toUpperCase(command) == 'Z') {
            closed = true;
            return;
        }
        if (closed || Character.toUpperCase(command) == 'M') {
            throw fault.of(
                    "more than one outline, the second at character " + at + " of d",
                    "break the path apart; an obstacle has one outline without holes");
        }
        switch (Character.toUpperCase(command)) {
            case 'L' -> line(fromX + number(), fromY + number());
            case 'H' -> line(fromX + number(), y);
            case 'V' -> line(x, fromY + number());
            case 'C' ->
                curve(
                        fromX + number(),
                        fromY + number(),
                        fromX + number(),
                        fromY + number(),
                        fromX + number(),
                        fromY + number());
            default ->
                throw fault.of(
                        "command " + ExchangeException.quoted(String.valueOf(command)) + " at character " + at
                                + " of d",
                        "draw it with M L H V C Z alone");
        }
    }

    private void line(double toX, double toY) throws ExchangeException {
        x = toX;
        y = toY;
        corner(x, y);
    }

    private void curve(double x1, double y1, double x2, double y2, double x3, double y3) throws ExchangeException {
        int pieces = isStraight(x1, y1, x2, y2, x3, y3) ? 1 : pieces(x1, y1, x2, y2, x3, y3);
        double x0 = x;
        double y0 = y;
        for (int i = 1; i < pieces; i++) {
            double t = (double) i / pieces;
            double s = 1 - t;
            line(
                    s * s * s * x0 + 3 * s * s * t * x1 + 3 * s * t * t * x2 + t * t * t * x3,
                    s * s * s * y0 + 3 * s * s * t * y1 + 3 * s * t * t * y2 + t * t * t * y3);
        }
        line(x3, y3);
    }

    /** Tells whether both inner control points lie on the chord, which the curve then never leaves. */
    private boolean isStraight(double x1, double y1, double x2, double y2, double x3, double y3) {
        return onChord(x1, y1, x3, y3) && onChord(x2, y2, x3, y3);
    }

    private boolean onChord(double px, double py, double toX, double toY) {
        double dx = toX - x;
        double dy = toY - y;
        double square = dx * dx + dy * dy;
        double along = square == 0 ? 0 : Math.max(0, Math.min(1, ((px - x) * dx + (py - y) * dy) / square));
        double offX = px - x - along * dx;
        double offY = py - y - along * dy;
        return offX * offX + offY * offY <= SAME * SAME;
    }

    /** Returns how many chords of equal parameter keep within {@link #FLATNESS} of a curve. */
    private int pieces(double x1, double y1, double x2, double y2, double x3, double y3) throws ExchangeException {
        double first = length(x - 2 * x1 + x2, y - 2 * y1 + y2);
        double second = length(x1 - 2 * x2 + x3, y1 - 2 * y2 + y3);
        double pieces = Math.ceil(Math.sqrt(0.75 * Math.max(first, second) / FLATNESS));
        if (!(pieces <= MAX_CORNERS)) {
            throw tooMany();
        }
        return Math.max(1, (int) pieces);
    }

    private static double length(double dx, double dy) {
        return Math.sqrt(dx * dx + dy * dy);
    }

    private void corner(double cornerX, double cornerY) throws ExchangeException {
        if (count > 0 && isSame(count - 2, cornerX, cornerY)) {
            return;
        }
        if (count == 2 * MAX_CORNERS) {
            throw tooMany();
        }
        if (count == corners.length) {
            corners = Arrays.copyOf(corners, 2 * count);
        }
        corners[count++] = cornerX;
        corners[count++] = cornerY;
    }

    private boolean isSame(int corner, double otherX, double otherY) {
        return Math.abs(corners[corner] - otherX) <= SAME && Math.abs(corners[corner + 1] - otherY) <= SAME;
    }

    private ExchangeException tooMany() {
        return fault.of("more than " + MAX_CORNERS + " corners", "cut it in two, or draw it with fewer nodes");
    }

    private double[] outline() {
        while (count > 2 && isSame(count - 2, corners[0], corners[1])) {
            count -= 2;
        }
        return Arrays.copyOf(corners, count);
    }

    /** Returns the next character that is no blank and no comma, 0 at the end. */
    private char peek() {
        while (at < text.length() && (text.charAt(at) <= ' ' || text.charAt(at) == ',')) {
            at++;
        }
        return at < text.length() ? text.charAt(at) : 0;
    }

    /** Reads a number; the next may follow without a blank where it begins with a sign or its own point. */
    private double number() throws ExchangeException {
        peek();
        int begin = at;
        sign();
        int digits = digits();
        if (at < text.length() && text.charAt(at) == '.') {
            at++;
            digits += digits();
        }
        if (digits == 0) {
            at = begin;
            throw found("give a number");
        }
        int end = at;
        if (at < text.length() && (text.charAt(at) | 0x20) == 'e') {
            at++;
            sign();
            end = digits() > 0 ? at : end;
            at = end;
        }
        double value = Double.parseDouble(text.substring(begin, end));
        if (!Double.isFinite(value)) {
            throw fault.of(
                    ExchangeException.quoted(text.substring(begin, end)) + " is not finite", "give it finite numbers");
        }
        return value;
    }

    private void sign() {
        if (at < text.length() && (text.charAt(at) == '+' || text.charAt(at) == '-')) {
            at++;
        }
    }

    private int digits() {
        int begin = at;
        while (at < text.length() && text.charAt(at) >= '0' && text.charAt(at) <= '9') {
            at++;
        }
        return at - begin;
    }

    private ExchangeException found(String cure) {
        if (at == text.length()) {
            return fault.of("d ends after " + at + " characters", cure);
        }
        String rest = ExchangeException.quoted(text.substring(at, at + 1));
        return fault.of("found " + rest + " at character " + (at + 1) + " of d", cure);
    }
}
