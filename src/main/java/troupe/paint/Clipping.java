package troupe.paint;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import troupe.geometry.Polygon;

/**
 * Turns polygons and lines in metres into paths in pixels, cut to the surroundings of what is seen: the
 * time to stroke a path, above all in dashes, grows with its length, and a scene may hold any numbers.
 */
public final class Clipping {
    private static final double AROUND = 4_000;
    private static final double WITHOUT_CLIP = 20_000;
    private static final double FAR = 1e9;

    private final Viewport view;
    private final Rectangle2D room;

    /** Makes a clipping to 4,000 pixels around the clip of the graphics. */
    public Clipping(Graphics2D g, Viewport view) {
        Rectangle clip = g.getClipBounds();
        this.view = view;
        this.room = clip == null
                ? new Rectangle2D.Double(-AROUND, -AROUND, WITHOUT_CLIP, WITHOUT_CLIP)
                : new Rectangle2D.Double(
                        clip.x - AROUND, clip.y - AROUND, clip.width + 2 * AROUND, clip.height + 2 * AROUND);
    }

    /** Returns a filled polygon as a closed path, even-odd; empty if nothing of it is left. */
    public Path2D polygon(Polygon polygon) {
        int n = polygon.size();
        double[] xs = new double[n];
        double[] ys = new double[n];
        boolean inside = true;
        for (int i = 0; i < n; i++) {
            xs[i] = bounded(view.px(polygon.x(i)));
            ys[i] = bounded(view.py(polygon.y(i)));
            inside &= room.contains(xs[i], ys[i]);
        }
        double[][] corners = {xs, ys};
        for (int side = 0; side < 4 && !inside; side++) {
            corners = cut(corners[0], corners[1], side);
        }
        return closed(corners[0], corners[1]);
    }

    private static double bounded(double pixel) {
        return Math.max(-FAR, Math.min(FAR, pixel));
    }

    private static Path2D closed(double[] xs, double[] ys) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD, xs.length + 1);
        for (int i = 0; i < xs.length; i++) {
            if (i == 0) {
                path.moveTo(xs[i], ys[i]);
            } else {
                path.lineTo(xs[i], ys[i]);
            }
        }
        if (xs.length > 0) {
            path.closePath();
        }
        return path;
    }

    /** Returns how far a point lies inside of a side of the room: left, right, top, bottom. */
    private double depth(int side, double x, double y) {
        return switch (side) {
            case 0 -> x - room.getMinX();
            case 1 -> room.getMaxX() - x;
            case 2 -> y - room.getMinY();
            default -> room.getMaxY() - y;
        };
    }

    /** Cuts a polygon at one side of the room (Sutherland and Hodgman, CACM 17(1), 1974). */
    private double[][] cut(double[] xs, double[] ys, int side) {
        double[] keptX = new double[2 * xs.length];
        double[] keptY = new double[2 * xs.length];
        int count = 0;
        for (int i = 0, j = xs.length - 1; i < xs.length; j = i++) {
            double from = depth(side, xs[j], ys[j]);
            double to = depth(side, xs[i], ys[i]);
            if (from >= 0 != to >= 0) {
                double share = from / (from - to);
                keptX[count] = xs[j] + share * (xs[i] - xs[j]);
                keptY[count++] = ys[j] + share * (ys[i] - ys[j]);
            }
            if (to >= 0) {
                keptX[count] = xs[i];
                keptY[count++] = ys[i];
            }
        }
        return new double[][] {java.util.Arrays.copyOf(keptX, count), java.util.Arrays.copyOf(keptY, count)};
    }

    /** Returns the open path through {@code values[k * stride], values[k * stride + 1]}, cut where it leaves the room. */
    public Path2D line(double[] values, int stride) {
        Path2D path = new Path2D.Double();
        boolean drawing = false;
        for (int k = stride; k + stride <= values.length; k += stride) {
            double[] piece = {
                bounded(view.px(values[k - stride])),
                bounded(view.py(values[k - stride + 1])),
                bounded(view.px(values[k])),
                bounded(view.py(values[k + 1]))
            };
            double endX = piece[2];
            double endY = piece[3];
            boolean starts = !drawing || !room.contains(piece[0], piece[1]);
            if (!shorten(piece)) {
                drawing = false;
                continue;
            }
            if (starts) {
                path.moveTo(piece[0], piece[1]);
            }
            path.lineTo(piece[2], piece[3]);
            drawing = piece[2] == endX && piece[3] == endY;
        }
        return path;
    }

    /** Shortens a piece to what lies in the room; false if nothing does (Liang and Barsky, TOG 3(1), 1984). */
    private boolean shorten(double[] p) {
        double enter = 0;
        double leave = 1;
        for (int side = 0; side < 4; side++) {
            double from = depth(side, p[0], p[1]);
            double to = depth(side, p[2], p[3]);
            if (from < 0 && to < 0 || Double.isNaN(from - to)) {
                return false;
            }
            if (from < 0) {
                enter = Math.max(enter, from / (from - to));
            } else if (to < 0) {
                leave = Math.min(leave, from / (from - to));
            }
        }
        if (enter > leave) {
            return false;
        }
        double dx = p[2] - p[0];
        double dy = p[3] - p[1];
        if (leave < 1) {
            p[2] = p[0] + leave * dx;
            p[3] = p[1] + leave * dy;
        }
        if (enter > 0) {
            p[0] += enter * dx;
            p[1] += enter * dy;
        }
        return true;
    }
}
