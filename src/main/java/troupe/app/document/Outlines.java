package troupe.app.document;

import troupe.geometry.Point;
import troupe.geometry.Polygon;

/** Makes changed outlines out of outlines: corner by corner, turned, scaled. Pure; safe on any thread; O(corners). */
public final class Outlines {
    private Outlines() {}

    /** Returns the outline with corner {@code i} elsewhere. */
    public static Polygon withCorner(Polygon outline, int i, Point at) {
        double[] xs = xs(outline);
        double[] ys = ys(outline);
        xs[i] = at.x();
        ys[i] = at.y();
        return new Polygon(xs, ys);
    }

    /** Returns the outline with a new corner between corner {@code i} and the next, with the number {@code i + 1}. */
    public static Polygon withCornerAfter(Polygon outline, int i, Point at) {
        double[] xs = new double[outline.size() + 1];
        double[] ys = new double[outline.size() + 1];
        for (int k = 0; k < xs.length; k++) {
            int from = k <= i ? k : k - 1;
            xs[k] = k == i + 1 ? at.x() : outline.x(from);
            ys[k] = k == i + 1 ? at.y() : outline.y(from);
        }
        return new Polygon(xs, ys);
    }

    /**
     * Returns the outline without corner {@code i}.
     *
     * @throws IllegalArgumentException if it has only three
     */
    public static Polygon withoutCorner(Polygon outline, int i) {
        if (outline.size() <= 3) {
            throw new IllegalArgumentException("an outline of " + outline.size() + " corners cannot lose one");
        }
        double[] xs = new double[outline.size() - 1];
        double[] ys = new double[outline.size() - 1];
        for (int k = 0; k < xs.length; k++) {
            xs[k] = outline.x(k < i ? k : k + 1);
            ys[k] = outline.y(k < i ? k : k + 1);
        }
        return new Polygon(xs, ys);
    }

    /** Returns the outline turned counter-clockwise about a place. */
    public static Polygon turned(Polygon outline, Point about, double rad) {
        double cos = Math.cos(rad);
        double sin = Math.sin(rad);
        double[] xs = xs(outline);
        double[] ys = ys(outline);
        for (int i = 0; i < xs.length; i++) {
            double dx = xs[i] - about.x();
            double dy = ys[i] - about.y();
            xs[i] = about.x() + dx * cos - dy * sin;
            ys[i] = about.y() + dx * sin + dy * cos;
        }
        return SceneEdits.rounded(new Polygon(xs, ys));
    }

    /** Returns the outline stretched about a place that stays. */
    public static Polygon scaled(Polygon outline, Point fixed, double factorX, double factorY) {
        double[] xs = xs(outline);
        double[] ys = ys(outline);
        for (int i = 0; i < xs.length; i++) {
            xs[i] = fixed.x() + (xs[i] - fixed.x()) * factorX;
            ys[i] = fixed.y() + (ys[i] - fixed.y()) * factorY;
        }
        return SceneEdits.rounded(new Polygon(xs, ys));
    }

    /** Returns a circle as a polygon of {@code corners} corners on it. */
    public static Polygon circle(Point centre, double radiusM, int corners) {
        double[] xs = new double[corners];
        double[] ys = new double[corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            xs[i] = centre.x() + radiusM * Math.cos(angle);
            ys[i] = centre.y() + radiusM * Math.sin(angle);
        }
        return SceneEdits.rounded(new Polygon(xs, ys));
    }

    private static double[] xs(Polygon outline) {
        double[] xs = new double[outline.size()];
        for (int i = 0; i < xs.length; i++) {
            xs[i] = outline.x(i);
        }
        return xs;
    }

    private static double[] ys(Polygon outline) {
        double[] ys = new double[outline.size()];
        for (int i = 0; i < ys.length; i++) {
            ys[i] = outline.y(i);
        }
        return ys;
    }
}
