package troupe.geometry;

/** Holds an axis-parallel rectangle in metres; all four sides belong to it. */
public record Box(double minX, double minY, double maxX, double maxY) {

    /**
     * Checks that the corners are in order.
     *
     * @throws IllegalArgumentException if a maximum lies below its minimum or a number is NaN
     */
    public Box {
        if (!(minX <= maxX) || !(minY <= maxY)) {
            throw new IllegalArgumentException(
                    "box [" + minX + ", " + maxX + "] x [" + minY + ", " + maxY + "]: maximum below minimum");
        }
    }

    /** Returns the extent along x in metres. */
    public double width() {
        return maxX - minX;
    }

    /** Returns the extent along y in metres. */
    public double depth() {
        return maxY - minY;
    }

    /** Returns this box grown by {@code margin} metres on every side. */
    public Box grown(double margin) {
        return new Box(minX - margin, minY - margin, maxX + margin, maxY + margin);
    }

    /** Tells whether the two closed boxes share a point. */
    public boolean meets(Box other) {
        return minX <= other.maxX && other.minX <= maxX && minY <= other.maxY && other.minY <= maxY;
    }

    /** Tells whether the closed box holds {@code (x, y)}. */
    public boolean contains(double x, double y) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }

    /** Returns the smallest box that holds both. */
    public Box union(Box other) {
        return new Box(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY));
    }
}
