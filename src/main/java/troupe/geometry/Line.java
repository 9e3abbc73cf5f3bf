package troupe.geometry;

/** Holds a directed straight line from a to b in metres; a and b may coincide. */
public record Line(double ax, double ay, double bx, double by) {

    /** Returns the length in metres. */
    public double length() {
        return Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
    }

    /** Returns the smallest box that holds the line. */
    public Box bounds() {
        return new Box(Math.min(ax, bx), Math.min(ay, by), Math.max(ax, bx), Math.max(ay, by));
    }

    /** Returns the least distance in metres to the outline of a polygon. Cost O(corners). */
    public double distance(Polygon polygon) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            least = Math.min(least, distanceSquared(polygon.x(j), polygon.y(j), polygon.x(i), polygon.y(i)));
        }
        return Math.sqrt(least);
    }

    /** Tells whether the outline of a polygon crosses the line properly; exact. Cost O(corners). */
    public boolean crosses(Polygon polygon) {
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            if (Segments.cross(ax, ay, bx, by, polygon.x(j), polygon.y(j), polygon.x(i), polygon.y(i))) {
                return true;
            }
        }
        return false;
    }

    /** Returns the squared distance in square metres to the segment c-d, 0 if they meet. */
    public double distanceSquared(double cx, double cy, double dx, double dy) {
        return Segments.distanceSquared(ax, ay, bx, by, cx, cy, dx, dy);
    }
}
