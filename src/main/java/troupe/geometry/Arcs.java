package troupe.geometry;

/** Measures circular arcs of the plane that are run through counter-clockwise; lengths in metres, no allocation. */
public final class Arcs {
    /** How much longer than it is, as a share of its length, a segment is taken at either end. */
    private static final double END = 1e-12;

    private Arcs() {}

    /**
     * Tells whether a closed arc about the origin shares a point with the closed segment {@code a-b}: the
     * line is cut with the circle. The ends of the segment reach 1e-12 of its length further, so that an arc
     * through a corner of an outline meets one of its edges at least.
     *
     * @param sx the x at which the arc begins, relative to its centre; {@code sy} likewise
     * @param ex the x at which it ends after turning by less than a full turn; {@code ey} likewise
     * @param wide whether it turns by more than a half turn
     */
    public static boolean meet(
            double sx, double sy, double ex, double ey, boolean wide, double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double squared = sx * sx + sy * sy;
        double length = dx * dx + dy * dy;
        double startA = ax * ax + ay * ay - squared;
        double startB = bx * bx + by * by - squared;
        if (startA < 0 && startB < 0) {
            return false;
        }
        if (length == 0) {
            return startA == 0 && holds(sx, sy, ex, ey, wide, ax, ay);
        }
        double half = -(ax * dx + ay * dy);
        double cross = ax * dy - ay * dx;
        double root = squared * length - cross * cross;
        if (root < 0) {
            return false;
        }
        double reach = Math.sqrt(root);
        return at(sx, sy, ex, ey, wide, ax, ay, dx, dy, (half - reach) / length)
                || at(sx, sy, ex, ey, wide, ax, ay, dx, dy, (half + reach) / length);
    }

    private static boolean at(
            double sx,
            double sy,
            double ex,
            double ey,
            boolean wide,
            double ax,
            double ay,
            double dx,
            double dy,
            double t) {
        return t >= -END && t <= 1 + END && holds(sx, sy, ex, ey, wide, ax + t * dx, ay + t * dy);
    }

    /** Tells whether the closed sector from the ray through s counter-clockwise to that through e holds a point. */
    private static boolean holds(double sx, double sy, double ex, double ey, boolean wide, double px, double py) {
        double fromStart = sx * py - sy * px;
        double toEnd = px * ey - py * ex;
        return wide ? fromStart >= 0 || toEnd >= 0 : fromStart >= 0 && toEnd >= 0;
    }
}
