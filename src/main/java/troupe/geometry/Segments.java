package troupe.geometry;

/** Measures straight segments of the plane; all lengths in metres. */
public final class Segments {
    private Segments() {}

    /**
     * Returns the squared distance from {@code (px, py)} to the closed segment {@code a-b}; the
     * segment may be a single point.
     */
    public static double distanceSquared(double px, double py, double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double along = (px - ax) * dx + (py - ay) * dy;
        double length = dx * dx + dy * dy;
        if (along <= 0 || length == 0) {
            return (px - ax) * (px - ax) + (py - ay) * (py - ay);
        }
        if (along >= length) {
            return (px - bx) * (px - bx) + (py - by) * (py - by);
        }
        double cross = (px - ax) * dy - (py - ay) * dx;
        return cross * cross / length;
    }

    /** Returns the point of the closed segment {@code a-b} that is nearest to {@code (px, py)}. */
    public static Point nearest(double px, double py, double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double length = dx * dx + dy * dy;
        double share = length == 0 ? 0 : Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / length));
        return new Point(ax + share * dx, ay + share * dy);
    }

    /** Tells whether the closed segments {@code a-b} and {@code c-d} share a point; exact. */
    public static boolean meet(double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
        if (Math.max(ax, bx) < Math.min(cx, dx)
                || Math.max(cx, dx) < Math.min(ax, bx)
                || Math.max(ay, by) < Math.min(cy, dy)
                || Math.max(cy, dy) < Math.min(ay, by)) {
            return false;
        }
        int c = Orientation.sign(ax, ay, bx, by, cx, cy);
        int d = Orientation.sign(ax, ay, bx, by, dx, dy);
        int a = Orientation.sign(cx, cy, dx, dy, ax, ay);
        int b = Orientation.sign(cx, cy, dx, dy, bx, by);
        return c * d <= 0 && a * b <= 0;
    }

    /** Tells whether the open segments {@code a-b} and {@code c-d} cross in exactly one inner point of both; exact. */
    public static boolean cross(
            double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
        return Orientation.sign(ax, ay, bx, by, cx, cy) * Orientation.sign(ax, ay, bx, by, dx, dy) < 0
                && Orientation.sign(cx, cy, dx, dy, ax, ay) * Orientation.sign(cx, cy, dx, dy, bx, by) < 0;
    }

    /** Returns the squared distance between the closed segments {@code a-b} and {@code c-d}, 0 if they meet. */
    public static double distanceSquared(
            double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
        if (meet(ax, ay, bx, by, cx, cy, dx, dy)) {
            return 0;
        }
        return Math.min(
                Math.min(distanceSquared(ax, ay, cx, cy, dx, dy), distanceSquared(bx, by, cx, cy, dx, dy)),
                Math.min(distanceSquared(cx, cy, ax, ay, bx, by), distanceSquared(dx, dy, ax, ay, bx, by)));
    }
}
