package troupe.scene;

/** Tells how large a grid this Java can plan on. */
public final class GridMemory {
    /** Bytes that planning takes for each cell and floor, fields and search included, measured and rounded up. */
    public static final long BYTES_PER_CELL = 160;

    /** Kernels index cells with an int and a few sheets of them. */
    private static final long MAX_CELLS = 1L << 27;

    private GridMemory() {}

    /** Returns the bytes that a grid may take: three quarters of what this Java may use. */
    public static long bytes() {
        return Runtime.getRuntime().maxMemory() / 4 * 3;
    }

    /** Returns the most cells that fit, floors above each other counted each. */
    public static double mostCells() {
        return Math.min(MAX_CELLS, bytes() / (double) BYTES_PER_CELL);
    }
}
