package troupe.scene;

/**
 * Holds the ground rectangle {@code [0, width] x [0, depth]} in metres, at elevation 0, and the edge
 * length {@code cell} of a grid cell in metres. Outside the world is solid.
 */
public record World(double width, double depth, double cell) {

    /** Makes a world whose cell divides its longer side by 256. */
    public static World of(double width, double depth) {
        return new World(width, depth, Math.max(width, depth) / 256);
    }

    /** Returns the number of grid columns, {@code ceil(width / cell - 1e-9)}. */
    public int cols() {
        return (int) Math.ceil(width / cell - 1e-9);
    }

    /** Returns the number of grid rows, {@code ceil(depth / cell - 1e-9)}. */
    public int rows() {
        return (int) Math.ceil(depth / cell - 1e-9);
    }
}
