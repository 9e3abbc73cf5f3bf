package troupe.paint;

import java.awt.geom.AffineTransform;
import troupe.geometry.Box;
import troupe.geometry.Point;

/**
 * Converts between metres, y up, and pixels, y down. The point {@code (left, top)} in metres lies at the
 * upper left corner; {@code scale} is in pixels per metre. Immutable; without rotation.
 */
public record Viewport(double left, double top, double scale) {
    /** The least scale in pixels per metre that zooming leads to. */
    public static final double MIN_SCALE = 0.01;

    /** The largest scale in pixels per metre that zooming leads to. */
    public static final double MAX_SCALE = 20_000;

    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if the scale is not positive and finite or a place is not finite
     */
    public Viewport {
        if (!(scale > 0) || Double.isInfinite(scale) || !Double.isFinite(left) || !Double.isFinite(top)) {
            throw new IllegalArgumentException(
                    "viewport at " + left + ", " + top + " with " + scale + " px/m; needs a finite scale above 0");
        }
    }

    /**
     * Makes the largest view of a box centred in a rectangle of {@code width x height} pixels at
     * {@code (x, y)}; sides below one pixel count as one.
     */
    public static Viewport fit(Box box, double x, double y, double width, double height) {
        double scale = Math.min(
                Math.max(1, width) / Math.max(1e-9, box.width()), Math.max(1, height) / Math.max(1e-9, box.depth()));
        double left = (box.minX() + box.maxX()) / 2 - (x + width / 2) / scale;
        double top = (box.minY() + box.maxY()) / 2 + (y + height / 2) / scale;
        return new Viewport(left, top, scale);
    }

    /** Makes the largest view of a box centred in {@code width x height} pixels, with a margin in pixels. */
    public static Viewport fit(Box box, int width, int height, int margin) {
        return fit(box, margin, margin, width - 2.0 * margin, height - 2.0 * margin);
    }

    /** Returns the pixel column of an x in metres. */
    public double px(double x) {
        return (x - left) * scale;
    }

    /** Returns the pixel row of a y in metres. */
    public double py(double y) {
        return (top - y) * scale;
    }

    /** Returns the x in metres of a pixel column. */
    public double x(double px) {
        return left + px / scale;
    }

    /** Returns the y in metres of a pixel row. */
    public double y(double py) {
        return top - py / scale;
    }

    /** Returns the place in metres of a pixel. */
    public Point point(double px, double py) {
        return new Point(x(px), y(py));
    }

    /** Returns the box in metres that {@code width x height} pixels show. */
    public Box shown(double width, double height) {
        return new Box(left, y(height), x(width), top);
    }

    /**
     * Returns this view with the scale multiplied by {@code factor}, the place under pixel
     * {@code (px, py)} staying there; the scale stays within {@link #MIN_SCALE} and {@link #MAX_SCALE}.
     */
    public Viewport zoomed(double factor, double px, double py) {
        double to = Math.max(MIN_SCALE, Math.min(MAX_SCALE, scale * factor));
        return new Viewport(x(px) - px / to, y(py) + py / to, to);
    }

    /** Returns this view with its content moved by {@code (dx, dy)} pixels, right and down. */
    public Viewport panned(double dx, double dy) {
        return new Viewport(left - dx / scale, top + dy / scale, scale);
    }

    /** Returns this view for a picture {@code factor} times as large. */
    public Viewport magnified(double factor) {
        return new Viewport(left, top, scale * factor);
    }

    /** Returns the transform from metres to pixels. */
    public AffineTransform transform() {
        return new AffineTransform(scale, 0, 0, -scale, -left * scale, top * scale);
    }
}
