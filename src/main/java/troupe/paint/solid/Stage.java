package troupe.paint.solid;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import troupe.geometry.Polygon;

/**
 * Draws prisms, floors, lines and discs in metres as a camera sees them, in any order. What is drawn as a
 * {@linkplain #figure figure} shows faintly through what hides it. Four samples make a pixel, one in very large
 * pictures. Serves one thread; a stage can be set anew for another camera and keeps its memory.
 */
public final class Stage {
    /** The most samples with which a pixel is still made of four. */
    private static final int MOST_SAMPLES = 1 << 24;

    /** Lines lie so many metres nearer than the faces that they run on. */
    private static final double LIFT = 0.012;

    private static final double LEFT_SHADE = 0.70;
    private static final double RIGHT_SHADE = 0.92;

    private DepthRaster raster = new DepthRaster(1, 1);
    private Camera camera = new Camera(Camera.Angle.DEFAULT, 0, 0, 1);
    private Camera seen = camera;
    private int factor = 1;
    private double density = 1;
    private double through;
    private double glass;
    private Color behind = Color.BLACK;

    /** Makes an empty stage. */
    public Stage() {}

    /**
     * Clears the stage for a picture of {@code width x height} pixels laid out for the camera and drawn
     * {@code density} times as large, at least 1; a draft has one sample for a pixel.
     */
    public void set(Camera view, int width, int height, double dense, boolean draft, Color background) {
        int wide = (int) Math.max(1, Math.round(width * dense));
        int high = (int) Math.max(1, Math.round(height * dense));
        factor = !draft && 4L * wide * high <= MOST_SAMPLES ? 2 : 1;
        seen = view;
        density = dense;
        camera = view.magnified(dense * factor);
        if (!raster.isOf(wide * factor, high * factor)) {
            raster = new DepthRaster(wide * factor, high * factor);
        }
        through = 0;
        glass = 0;
        behind = background;
        raster.clear(background.getRGB() & 0xffffff);
    }

    /** Returns the camera as the picture is laid out. */
    public Camera camera() {
        return seen;
    }

    /** Returns the picture as it stands. */
    public BufferedImage image() {
        return raster.image(factor);
    }

    /**
     * Begins a figure, or with 0 goes back to solid things.
     *
     * @param hidden with what opacity it shows through what hides it, 0 to 1
     */
    public void figure(double hidden) {
        through = hidden;
        glass = 0;
        raster.begin();
    }

    /**
     * Begins a thing of glass, to be drawn after all that is solid: it covers with this opacity, above 0, what lies
     * behind it.
     */
    public void glass(double opacity) {
        through = 0;
        glass = opacity;
        raster.begin();
    }

    /** Drops what has been drawn so far, but where it is seen through one of these level holes. */
    public void keepWithin(List<Polygon> holes, double z) {
        raster.begin();
        holes.forEach(hole -> raster.mark(columns(hole), rows(hole, z)));
        raster.keepMarked(behind.getRGB() & 0xffffff);
    }

    private DepthRaster.Ink ink(Color colour) {
        return new DepthRaster.Ink(colour.getRGB() & 0xffffff, through, false, glass);
    }

    private double[] columns(Polygon outline) {
        double[] xs = new double[outline.size()];
        for (int i = 0; i < xs.length; i++) {
            xs[i] = camera.px(outline.x(i), outline.y(i));
        }
        return xs;
    }

    private double[] rows(Polygon outline, double z) {
        double[] ys = new double[outline.size()];
        for (int i = 0; i < ys.length; i++) {
            ys[i] = camera.py(outline.x(i), outline.y(i), z);
        }
        return ys;
    }

    /** Draws a level face at an elevation in metres, without what lies in one of the holes. */
    public void floor(Polygon outline, double z, Color colour, List<Polygon> holes) {
        if (!holes.isEmpty()) {
            raster.begin();
            holes.forEach(hole -> raster.mark(columns(hole), rows(hole, z)));
        }
        DepthRaster.Ink ink = new DepthRaster.Ink(colour.getRGB() & 0xffffff, 0, true, 0);
        raster.fill(columns(outline), rows(outline, z), camera.floor(z), holes.isEmpty() ? ink(colour) : ink);
    }

    /** Draws a prism from elevation {@code low} to {@code high} in metres: its top, and the sides that face the eye. */
    public void prism(Polygon outline, double low, double high, Color top, Color side) {
        boolean left = outline.signedArea() >= 0;
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            int from = left ? j : i;
            int to = left ? i : j;
            side(outline.x(from), outline.y(from), outline.x(to), outline.y(to), low, high, side);
        }
        floor(outline, high, top, List.of());
    }

    /**
     * Draws an upright face from elevation {@code low} to {@code high}, which is seen only from its right-hand side,
     * going from the first place to the second.
     */
    public void side(double x0, double y0, double x1, double y1, double low, double high, Color colour) {
        double c0 = camera.px(x0, y0);
        double c1 = camera.px(x1, y1);
        if (!(c1 - c0 > 1e-9) || !(high > low)) {
            return;
        }
        double[] xs = {c0, c1, c1, c0};
        double[] ys = {camera.py(x0, y0, low), camera.py(x1, y1, low), camera.py(x1, y1, high), camera.py(x0, y0, high)
        };
        double back = camera.angle().v(x1, y1) - camera.angle().v(x0, y0);
        double across = (c1 - c0) / camera.scale();
        double turn = 0.5 + 0.5 * back / Math.hypot(across, back);
        raster.fill(
                xs,
                ys,
                camera.wall(x0, y0, x1, y1),
                ink(shade(colour, LEFT_SHADE + (RIGHT_SHADE - LEFT_SHADE) * turn)));
    }

    private static Color shade(Color colour, double share) {
        return new Color((int) Math.round(colour.getRed() * share), (int) Math.round(colour.getGreen() * share), (int)
                Math.round(colour.getBlue() * share));
    }

    /** Draws the outline of a level face, {@code width} pixels wide. */
    public void outline(Polygon outline, double z, double width, Color colour, float... dashes) {
        double[] points = new double[3 * outline.size() + 3];
        for (int i = 0; i <= outline.size(); i++) {
            points[3 * i] = outline.x(i % outline.size());
            points[3 * i + 1] = outline.y(i % outline.size());
            points[3 * i + 2] = z;
        }
        line(points, width, colour, dashes);
    }

    /**
     * Draws a line through {@code x, y, z} triples in metres.
     *
     * @param width its width in pixels
     * @param dashes lengths in pixels, on and off in turn; none for a line without gaps
     */
    public void line(double[] points, double width, Color colour, float... dashes) {
        Dashes pattern = new Dashes(dashes, density * factor);
        for (int i = 3; i < points.length; i += 3) {
            Spot from = spot(points[i - 3], points[i - 2], points[i - 1]);
            Spot to = spot(points[i], points[i + 1], points[i + 2]);
            pattern.cut(from, to, (a, b) -> segment(a, b, width * density * factor, colour));
        }
    }

    /** A sample with its depth. */
    record Spot(double x, double y, double depth) {
        Spot towards(Spot other, double share) {
            return new Spot(
                    x + share * (other.x - x), y + share * (other.y - y), depth + share * (other.depth - depth));
        }
    }

    private Spot spot(double x, double y, double z) {
        return new Spot(camera.px(x, y), camera.py(x, y, z), camera.depth(x, y, z) + LIFT);
    }

    /** Draws a piece of a line with round ends, across it as level as a floor. */
    private void segment(Spot from, Spot to, double width, Color colour) {
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double length = Math.hypot(dx, dy);
        double level = camera.floor(0).b();
        double rise = length < 1e-9 ? 0 : (to.depth() - from.depth() - level * dy) / (length * length);
        double a = rise * dx;
        double b = level + rise * dy;
        Camera.Plane plane = new Camera.Plane(a, b, from.depth() - a * from.x() - b * from.y());
        double reach = width / 2;
        if (reach < 1.6) {
            double sideX = length < 1e-9 ? 0 : -dy / length * reach;
            double sideY = length < 1e-9 ? reach : dx / length * reach;
            double[] xs = {from.x() + sideX, to.x() + sideX, to.x() - sideX, from.x() - sideX};
            double[] ys = {from.y() + sideY, to.y() + sideY, to.y() - sideY, from.y() - sideY};
            raster.fill(xs, ys, plane, ink(colour));
            return;
        }
        double heading = Math.atan2(dy, dx);
        int half = 6;
        double[] xs = new double[2 * half + 2];
        double[] ys = new double[2 * half + 2];
        for (int k = 0; k <= half; k++) {
            double turn = heading + Math.PI / 2 - Math.PI * k / half;
            xs[k] = to.x() + reach * Math.cos(turn);
            ys[k] = to.y() + reach * Math.sin(turn);
            xs[half + 1 + k] = from.x() - reach * Math.cos(turn);
            ys[half + 1 + k] = from.y() - reach * Math.sin(turn);
        }
        raster.fill(xs, ys, plane, ink(colour));
    }

    /** Draws a ball of a radius in metres, at least {@code least} pixels. */
    public void ball(double x, double y, double z, double radius, double least, Color colour) {
        double reach = Math.max(radius * camera.scale(), least * density * factor);
        face(x, y, z, radius, colour, circle(reach));
    }

    private static double[] circle(double reach) {
        int corners = 24;
        double[] around = new double[2 * corners];
        for (int k = 0; k < corners; k++) {
            around[2 * k] = reach * Math.cos(2 * Math.PI * k / corners);
            around[2 * k + 1] = reach * Math.sin(2 * Math.PI * k / corners);
        }
        return around;
    }

    /** Draws a flag that always faces the eye: corners {@code x, y} in pixels right and up of a place in metres. */
    public void flag(double x, double y, double z, Color colour, double... corners) {
        double[] larger = new double[corners.length];
        for (int i = 0; i < corners.length; i++) {
            larger[i] = corners[i] * density * factor * (i % 2 == 0 ? 1 : -1);
        }
        face(x, y, z, 0, colour, larger);
    }

    private void face(double x, double y, double z, double nearer, Color colour, double[] corners) {
        double[] xs = new double[corners.length / 2];
        double[] ys = new double[corners.length / 2];
        for (int k = 0; k < xs.length; k++) {
            xs[k] = camera.px(x, y) + corners[2 * k];
            ys[k] = camera.py(x, y, z) + corners[2 * k + 1];
        }
        Camera.Plane plane = new Camera.Plane(0, 0, camera.depth(x, y, z) + nearer + LIFT);
        raster.fill(xs, ys, plane, ink(colour));
    }
}
