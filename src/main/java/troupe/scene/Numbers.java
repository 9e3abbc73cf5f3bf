package troupe.scene;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.StringTokenizer;
import troupe.geometry.Polygon;

/** Reads and writes the numbers of scene files: decimal points in any locale, shortest form that reads back equal. */
public final class Numbers {
    /** The most corners of one polygon of a file, so that checking it for crossings stays cheap. */
    public static final int MAX_CORNERS = 10_000;

    private Numbers() {}

    /** Returns the shortest text that reads back to the same double, without a trailing {@code .0}. */
    public static String text(double value) {
        String text = Double.toString(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }

    /** Returns {@code x,y} or {@code x,y,z}. */
    public static String text(Place place) {
        String flat = text(place.x()) + "," + text(place.y());
        return place.z().isPresent() ? flat + "," + text(place.z().getAsDouble()) : flat;
    }

    /** Returns the corners as {@code x,y x,y …}. */
    public static String text(Polygon outline) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < outline.size(); i++) {
            text.append(i == 0 ? "" : " ")
                    .append(text(outline.x(i)))
                    .append(',')
                    .append(text(outline.y(i)));
        }
        return text.toString();
    }

    /**
     * Reads a number; {@code NaN} and {@code Infinity} are read as such, for the checks to name.
     *
     * @throws IllegalArgumentException if it is none
     */
    public static double number(String text) {
        try {
            return Double.parseDouble(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + shortened(text) + "' where a number is expected", e);
        }
    }

    /**
     * Reads a whole number.
     *
     * @throws IllegalArgumentException if it is none
     */
    public static long whole(String text) {
        try {
            return Long.parseLong(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + shortened(text) + "' where a whole number is expected", e);
        }
    }

    /**
     * Reads {@code x,y} or {@code x,y,z}.
     *
     * @throws IllegalArgumentException if it is neither
     */
    public static Place place(String text) {
        String[] parts = text.strip().split(",", -1);
        if (parts.length != 2 && parts.length != 3) {
            throw new IllegalArgumentException("'" + shortened(text) + "' where x,y or x,y,z is expected");
        }
        OptionalDouble z = parts.length == 3 ? OptionalDouble.of(number(parts[2])) : OptionalDouble.empty();
        return new Place(number(parts[0]), number(parts[1]), z);
    }

    /**
     * Reads corners written as {@code x,y x,y …}, any white space between them.
     *
     * @throws IllegalArgumentException if a corner is not {@code x,y}, there is none, or there are more than
     *     {@value #MAX_CORNERS}
     */
    public static Polygon polygon(String text) {
        double[] xs = new double[8];
        double[] ys = new double[8];
        int count = 0;
        StringTokenizer corners = new StringTokenizer(text);
        while (corners.hasMoreTokens()) {
            if (count == MAX_CORNERS) {
                throw new IllegalArgumentException("more than " + MAX_CORNERS + " corners; cut the polygon in two");
            }
            if (count == xs.length) {
                xs = Arrays.copyOf(xs, 2 * count);
                ys = Arrays.copyOf(ys, 2 * count);
            }
            String corner = corners.nextToken();
            int comma = corner.indexOf(',');
            if (comma < 0 || corner.indexOf(',', comma + 1) >= 0) {
                throw new IllegalArgumentException("corner '" + shortened(corner) + "' where x,y is expected");
            }
            xs[count] = number(corner.substring(0, comma));
            ys[count] = number(corner.substring(comma + 1));
            if (!Double.isFinite(xs[count]) || !Double.isFinite(ys[count])) {
                throw new IllegalArgumentException(
                        "corner '" + shortened(corner) + "' where finite numbers are expected");
            }
            count++;
        }
        if (count == 0) {
            throw new IllegalArgumentException("no corner where x,y x,y … is expected");
        }
        return new Polygon(Arrays.copyOf(xs, count), Arrays.copyOf(ys, count));
    }

    /** Returns a text on one line, cut where it is too long for a message. */
    private static String shortened(String text) {
        String start = text.length() <= 40 ? text : text.substring(0, 40) + "…";
        return start.replaceAll("\\s+", " ");
    }
}
