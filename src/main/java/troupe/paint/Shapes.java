package troupe.paint;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.Locale;
import troupe.geometry.Polygon;

/** Makes the shapes, numbers and colours that the painters share. */
public final class Shapes {
    private static final double HATCH_ANGLE = Math.toRadians(-20);

    private Shapes() {}

    /** Returns a copy of the graphics that draws smooth lines and text; the caller disposes of it. */
    public static Graphics2D smooth(Graphics2D g) {
        Graphics2D copy = (Graphics2D) g.create();
        copy.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        copy.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        copy.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        copy.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        copy.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        return copy;
    }

    /** Returns the direction in radians of the grain of a wooden outline: it turns with the first edge. */
    public static double grain(Polygon outline) {
        int next = 1 % outline.size();
        return HATCH_ANGLE + StrictMath.atan2(outline.y(next) - outline.y(0), outline.x(next) - outline.x(0));
    }

    /**
     * Returns parallel lines inside a shape of straight edges, {@code spacing} pixels apart, tied to its centre.
     *
     * @param angle their direction in radians, counter-clockwise as seen
     */
    public static Path2D hatch(Shape shape, double spacing, double angle) {
        Rectangle2D box = shape.getBounds2D();
        AffineTransform turn = AffineTransform.getRotateInstance(angle, box.getCenterX(), box.getCenterY());
        Path2D turned = new Path2D.Double(shape, turn);
        Rectangle2D bounds = turned.getBounds2D();
        Path2D lines = new Path2D.Double();
        int reach = (int) Math.min(10_000, bounds.getHeight() / 2 / spacing);
        for (int k = -reach; k <= reach; k++) {
            double y = box.getCenterY() + k * spacing;
            double[] xs = crossings(turned, y);
            for (int i = 0; i + 1 < xs.length; i += 2) {
                lines.moveTo(xs[i], y);
                lines.lineTo(xs[i + 1], y);
            }
        }
        lines.transform(AffineTransform.getRotateInstance(-angle, box.getCenterX(), box.getCenterY()));
        return lines;
    }

    private static double[] crossings(Path2D path, double y) {
        double[] found = new double[8];
        int count = 0;
        double[] point = new double[6];
        double startX = 0;
        double startY = 0;
        double x = 0;
        double fromY = 0;
        for (PathIterator it = path.getPathIterator(null); !it.isDone(); it.next()) {
            int kind = it.currentSegment(point);
            if (kind == PathIterator.SEG_MOVETO) {
                startX = point[0];
                startY = point[1];
            } else {
                double toX = kind == PathIterator.SEG_CLOSE ? startX : point[0];
                double toY = kind == PathIterator.SEG_CLOSE ? startY : point[1];
                if ((fromY <= y) != (toY <= y)) {
                    found = count == found.length ? Arrays.copyOf(found, 2 * count) : found;
                    found[count++] = x + (y - fromY) * (toX - x) / (toY - fromY);
                }
                point[0] = toX;
                point[1] = toY;
            }
            x = point[0];
            fromY = point[1];
        }
        double[] xs = Arrays.copyOf(found, count);
        Arrays.sort(xs);
        return xs;
    }

    /** Returns a length in metres with at most two decimals and a true minus sign. */
    public static String metres(double value) {
        String text = String.format(Locale.ROOT, "%.2f", Math.abs(value));
        String shorter = text.endsWith("0") ? text.substring(0, text.length() - 1) : text;
        return (value < 0 ? "−" : "") + shorter;
    }

    /** Returns the colour {@code share} of the way from one to another, opaque. */
    public static Color blend(Color from, Color to, double share) {
        return new Color(
                part(from.getRed(), to.getRed(), share),
                part(from.getGreen(), to.getGreen(), share),
                part(from.getBlue(), to.getBlue(), share));
    }

    private static int part(int from, int to, double share) {
        return (int) Math.round(from + (to - from) * Math.max(0, Math.min(1, share)));
    }

    /** Returns how light a colour is, in [0, 255]. */
    public static double lightness(Color colour) {
        return 0.299 * colour.getRed() + 0.587 * colour.getGreen() + 0.114 * colour.getBlue();
    }

    /** Returns black or white, whichever reads better on the colour. */
    public static Color ink(Color fill) {
        return lightness(fill) > 140 ? Tone.TEXT.light() : Color.WHITE;
    }

    /** Reads {@code #rrggbb}; anything else gives the other colour. */
    public static Color colour(String text, Color other) {
        return text.matches("#[0-9a-fA-F]{6}") ? new Color(Integer.parseInt(text.substring(1), 16)) : other;
    }
}
