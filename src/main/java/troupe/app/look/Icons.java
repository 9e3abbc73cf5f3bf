package troupe.app.look;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Locale;
import javax.swing.Icon;

/** Draws the line icons of the studio, one family, in a square of 20 units. */
public enum Icons {
    SELECT("M5 3 L15 9 L10.5 10.2 L8 15 Z"),
    POLYGON("M4 7 L11 3 L17 9 L13 16 L5 15 Z"),
    RECTANGLE("M3.5 5 H16.5 V15 H3.5 Z"),
    CIRCLE("O10 10 6.5"),
    DITCH("M2.5 7 H6 L8 13 H12 L14 7 H17.5"),
    JOURNEY("O4.6 15 2.1 M13 16 V3 L17.5 5.4 L13 7.8 M7.4 13.4 L10 11"),
    ACTOR("O10 4 2 M10 6 V12 M5.5 8.5 H14.5 M10 12 L6.5 17 M10 12 L13.5 17"),
    AVATAR("O5.4 14 2.6 M8.4 12.4 L12.4 10.2 M14.4 8.2 L15.8 5.4 O16.6 3.4 1"),
    GROUP("O6.2 7 2.4 O13.8 7 2.4 O10 13.6 2.4"),
    PAN("M10 3 V17 M3 10 H17 M8 5 L10 3 L12 5 M8 15 L10 17 L12 15 M5 8 L3 10 L5 12 M15 8 L17 10 L15 12"),
    START("O10 10 5.5 O10 10 1.2"),
    GOAL("M5 17 V3 L14 6.5 L5 10"),
    MEASURE("M3 13 L13 3 L17 7 L7 17 Z M6 10 L8 12 M9 7 L11 9"),
    FIT("M3 7 V3 H7 M13 3 H17 V7 M17 13 V17 H13 M7 17 H3 V13"),
    FIRST("M5 4 V16 M16 4 L8 10 L16 16 Z", true),
    BACK("M13 4 L6 10 L13 16 Z", true),
    PLAY("M6 3.5 V16.5 L16.5 10 Z", true),
    PAUSE("M6 4 V16 H8.4 V4 Z M11.6 4 V16 H14 V4 Z", true),
    FORWARD("M7 4 L14 10 L7 16 Z", true),
    LOOP("M15.5 8 A5.8 M16 4 V8 H12"),
    SEARCH("O8.6 8.6 5 M12.4 12.4 L16.5 16.5"),
    CLOSE("M5 5 L15 15 M15 5 L5 15"),
    DOWN("M6 8 L10 12 L14 8");

    private final Path2D path;
    private final boolean filled;

    Icons(String drawing) {
        this(drawing, false);
    }

    Icons(String drawing, boolean filled) {
        this.path = parse(drawing);
        this.filled = filled;
    }

    /** Finds an icon by its word, in any case. */
    public static Icons of(String word) {
        return valueOf(word.toUpperCase(Locale.ROOT));
    }

    /** Reads M, L, H, V, Z as in SVG with absolute numbers; {@code O x y r} is a circle, {@code A r} most of one. */
    private static Path2D parse(String drawing) {
        Path2D path = new Path2D.Double();
        String[] words = drawing.replaceAll("([A-Z])", " $1 ").trim().split("\\s+");
        int i = 0;
        while (i < words.length) {
            i = append(path, words, i);
        }
        return path;
    }

    private static int append(Path2D path, String[] words, int i) {
        switch (words[i]) {
            case "M" -> path.moveTo(number(words, i + 1), number(words, i + 2));
            case "L" -> path.lineTo(number(words, i + 1), number(words, i + 2));
            case "H" -> path.lineTo(number(words, i + 1), path.getCurrentPoint().getY());
            case "V" -> path.lineTo(path.getCurrentPoint().getX(), number(words, i + 1));
            case "O" -> path.append(circle(number(words, i + 1), number(words, i + 2), number(words, i + 3)), false);
            case "A" ->
                path.append(
                        new java.awt.geom.Arc2D.Double(
                                10 - 5.8, 10 - 5.8, 11.6, 11.6, 20, 290, java.awt.geom.Arc2D.OPEN),
                        false);
            default -> path.closePath();
        }
        return switch (words[i]) {
            case "M", "L" -> i + 3;
            case "O" -> i + 4;
            case "Z" -> i + 1;
            default -> i + 2;
        };
    }

    private static Shape circle(double x, double y, double r) {
        return new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
    }

    private static double number(String[] words, int i) {
        return Double.parseDouble(words[i]);
    }

    /** Draws the icon with its upper left corner at {@code (x, y)}, {@code size} pixels wide. */
    public void paint(Graphics graphics, double x, double y, double size, Color color) {
        Graphics2D g = Look.smooth(graphics);
        g.translate(x, y);
        g.scale(size / 20, size / 20);
        g.setColor(color);
        g.setStroke(new BasicStroke(1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        if (filled) {
            g.fill(path);
        }
        g.draw(path);
        g.dispose();
    }

    /** Returns the icon for a Swing component, in the component's foreground. */
    public Icon icon(int size) {
        return new Icon() {
            @Override
            public void paintIcon(Component component, Graphics graphics, int x, int y) {
                paint(graphics, x, y, size, component.getForeground());
            }

            @Override
            public int getIconWidth() {
                return size;
            }

            @Override
            public int getIconHeight() {
                return size;
            }
        };
    }
}
