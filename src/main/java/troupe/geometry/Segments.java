package troupe.geometry;

/** Measures straight segments of the plane; all lengths in metres, no allocation. */
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
}
