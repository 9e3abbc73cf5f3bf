package troupe.unified.reference;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Polygon;

/** Measures polygons the slow way: by their edges one by one, and by the triangles that they are cut into. */
public final class Shapes {
    private Shapes() {}

    /** Tells whether a point is inside: it is to the left of an odd number of edges that pass its height. */
    static boolean inside(Polygon p, double x, double y) {
        boolean in = false;
        for (int i = 0; i < p.size(); i++) {
            int j = (i + 1) % p.size();
            boolean up = p.y(i) <= y && y < p.y(j);
            boolean down = p.y(j) <= y && y < p.y(i);
            if ((up || down) && p.x(i) + (y - p.y(i)) / (p.y(j) - p.y(i)) * (p.x(j) - p.x(i)) > x) {
                in = !in;
            }
        }
        return in;
    }

    /** Returns the distance from a point to a segment. */
    static double distance(double x, double y, double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double squared = dx * dx + dy * dy;
        double share = squared == 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / squared));
        double ex = ax + share * dx - x;
        double ey = ay + share * dy - y;
        return Math.sqrt(ex * ex + ey * ey);
    }

    /** Returns the distance from a point to a filled polygon, 0 inside. */
    public static double distance(Polygon p, double x, double y) {
        double least = inside(p, x, y) ? 0 : Double.POSITIVE_INFINITY;
        for (int i = 0; i < p.size() && least > 0; i++) {
            int j = (i + 1) % p.size();
            least = Math.min(least, distance(x, y, p.x(i), p.y(i), p.x(j), p.y(j)));
        }
        return least;
    }

    /** Returns the distance between two segments, 0 where they cross. */
    static double distance(double[] a, double[] b) {
        double d1 = side(b, a[0], a[1]);
        double d2 = side(b, a[2], a[3]);
        double d3 = side(a, b[0], b[1]);
        double d4 = side(a, b[2], b[3]);
        if (d1 * d2 < 0 && d3 * d4 < 0) {
            return 0;
        }
        return Math.min(
                Math.min(distance(a[0], a[1], b[0], b[1], b[2], b[3]), distance(a[2], a[3], b[0], b[1], b[2], b[3])),
                Math.min(distance(b[0], b[1], a[0], a[1], a[2], a[3]), distance(b[2], b[3], a[0], a[1], a[2], a[3])));
    }

    private static double side(double[] s, double x, double y) {
        return (s[2] - s[0]) * (y - s[1]) - (s[3] - s[1]) * (x - s[0]);
    }

    /** Returns the distance from a segment {@code ax, ay, bx, by} to a filled polygon, 0 where they meet. */
    static double distance(Polygon p, double[] segment) {
        double least =
                inside(p, segment[0], segment[1]) || inside(p, segment[2], segment[3]) ? 0 : Double.POSITIVE_INFINITY;
        for (int i = 0; i < p.size() && least > 0; i++) {
            int j = (i + 1) % p.size();
            least = Math.min(least, distance(segment, new double[] {p.x(i), p.y(i), p.x(j), p.y(j)}));
        }
        return least;
    }

    /** Tells whether some stretch of a segment runs through the open square around a point. */
    static boolean touches(double[] segment, double x, double y, double half) {
        double from = 0;
        double to = 1;
        for (int axis = 0; axis < 2; axis++) {
            double at = segment[axis] - (axis == 0 ? x : y);
            double by = segment[2 + axis] - segment[axis];
            if (Math.abs(by) < 1e-12) {
                if (Math.abs(at) >= half - 1e-9) {
                    return false;
                }
                continue;
            }
            from = Math.max(from, Math.min((-half - at) / by, (half - at) / by));
            to = Math.min(to, Math.max((-half - at) / by, (half - at) / by));
        }
        return to - from > 1e-9;
    }

    /** Tells whether an outline runs through the open square around a point. */
    static boolean touches(Polygon p, double x, double y, double half) {
        for (int i = 0; i < p.size(); i++) {
            int j = (i + 1) % p.size();
            if (touches(new double[] {p.x(i), p.y(i), p.x(j), p.y(j)}, x, y, half)) {
                return true;
            }
        }
        return false;
    }

    /** Returns the centroid of a polygon's area, from triangles about its first corner. */
    static double[] centroid(Polygon p) {
        double area = 0;
        double x = 0;
        double y = 0;
        for (int i = 1; i + 1 < p.size(); i++) {
            double ax = p.x(i) - p.x(0);
            double ay = p.y(i) - p.y(0);
            double bx = p.x(i + 1) - p.x(0);
            double by = p.y(i + 1) - p.y(0);
            double twice = ax * by - ay * bx;
            area += twice;
            x += twice * (ax + bx) / 3;
            y += twice * (ay + by) / 3;
        }
        return new double[] {p.x(0) + x / area, p.y(0) + y / area};
    }

    /** Cuts a simple polygon into triangles {@code x0, y0, x1, y1, x2, y2}, counter-clockwise, ear by ear. */
    static List<double[]> triangles(Polygon p) {
        List<double[]> left = new ArrayList<>();
        for (int i = 0; i < p.size(); i++) {
            int k = p.signedArea() > 0 ? i : p.size() - 1 - i;
            left.add(new double[] {p.x(k), p.y(k)});
        }
        List<double[]> triangles = new ArrayList<>();
        while (left.size() > 2) {
            int ear = ear(left);
            double[] a = left.get((ear + left.size() - 1) % left.size());
            double[] b = left.get(ear);
            double[] c = left.get((ear + 1) % left.size());
            if (turn(a, b, c) > 1e-15) {
                triangles.add(new double[] {a[0], a[1], b[0], b[1], c[0], c[1]});
            }
            left.remove(ear);
        }
        return triangles;
    }

    private static int ear(List<double[]> corners) {
        int n = corners.size();
        for (int i = 0; i < n; i++) {
            double[] a = corners.get((i + n - 1) % n);
            double[] b = corners.get(i);
            double[] c = corners.get((i + 1) % n);
            boolean ear = turn(a, b, c) >= 0;
            for (int k = 0; k < n && ear; k++) {
                double[] d = corners.get(k);
                ear = d == a || d == b || d == c || turn(a, b, d) < 0 || turn(b, c, d) < 0 || turn(c, a, d) < 0;
            }
            if (ear) {
                return i;
            }
        }
        throw new IllegalArgumentException("no ear among " + n + " corners; needs a simple polygon");
    }

    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /**
     * Returns how far a triangle that is carried by {@code (vx, vy)} and another one lie apart along the edge
     * normal that separates them best; minus the depth at which they overlap where that is below 0.
     */
    static double apart(double[] moving, double vx, double vy, double[] still) {
        double most = Math.max(along(moving, moving, vx, vy, still), along(still, moving, vx, vy, still));
        double length = Math.sqrt(vx * vx + vy * vy);
        return length == 0 ? most : Math.max(most, alongNormal(-vy / length, vx / length, moving, vx, vy, still));
    }

    private static double along(double[] edges, double[] moving, double vx, double vy, double[] still) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 6; i += 2) {
            double dx = edges[(i + 2) % 6] - edges[i];
            double dy = edges[(i + 3) % 6] - edges[i + 1];
            double length = Math.sqrt(dx * dx + dy * dy);
            most = Math.max(most, alongNormal(-dy / length, dx / length, moving, vx, vy, still));
        }
        return most;
    }

    private static double alongNormal(double nx, double ny, double[] moving, double vx, double vy, double[] still) {
        double by = vx * nx + vy * ny;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        double otherLow = Double.POSITIVE_INFINITY;
        double otherHigh = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 6; i += 2) {
            double at = moving[i] * nx + moving[i + 1] * ny;
            low = Math.min(low, at);
            high = Math.max(high, at);
            double other = still[i] * nx + still[i + 1] * ny;
            otherLow = Math.min(otherLow, other);
            otherHigh = Math.max(otherHigh, other);
        }
        return Math.max(otherLow - Math.max(high, high + by), Math.min(low, low + by) - otherHigh);
    }

    /** Tells whether two polygons share area: two of their triangles overlap by more than {@code slack} metres. */
    public static boolean overlap(Polygon a, Polygon b, double slack) {
        for (double[] t : triangles(a)) {
            for (double[] u : triangles(b)) {
                if (apart(t, 0, 0, u) < -slack) {
                    return true;
                }
            }
        }
        return false;
    }
}
