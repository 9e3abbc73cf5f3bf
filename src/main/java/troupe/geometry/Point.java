package troupe.geometry;

/** Holds a point of the plane in metres. */
public record Point(double x, double y) {

    /** Returns the Euclidean distance to {@code (px, py)} in metres. */
    public double distance(double px, double py) {
        return Math.sqrt((px - x) * (px - x) + (py - y) * (py - y));
    }

    /** Returns the Euclidean distance to another point in metres. */
    public double distance(Point other) {
        return distance(other.x, other.y);
    }
}
