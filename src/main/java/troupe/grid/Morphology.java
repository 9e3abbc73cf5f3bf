package troupe.grid;

import java.util.Arrays;

/**
 * Erodes, dilates, opens and closes masks by a disc. The disc of radius {@code r} cells is the set of cell
 * offsets {@code (dx, dy)} with {@code dx² + dy² <= r²}, so results are exactly those of a distance
 * transform cut at {@code r}; because only the cut is wanted, the second pass of the transform becomes two
 * sweeps that carry how far the disc of each column reaches. The cost is bounded whatever the radius; small
 * discs grow on rows of bits instead, which is cheaper still.
 *
 * <p>A mask is one byte per cell, row-major, set where it is not 0; results hold 0 and 1. The plane outside
 * the grid counts as all set or all clear, as the caller says, and the operators are exact with respect to
 * that infinite plane. Input and output may be the same array. An instance holds scratch for one grid size
 * and a largest radius, and is used by one thread at a time; the operators allocate nothing.
 *
 * <p>Source: Unified section 5 (opening, {@code A o B = (A - B) + B}).
 */
public final class Morphology {
    /** Slack on squared radii, in cells², so that a radius computed from metres keeps its outermost cells. */
    private static final double SLACK = 1e-6;

    /** Up to this reach in cells rows of bits are faster than the sweeps. */
    private static final int LARGEST_OF_BITS = 40;

    private final int cols;
    private final int rows;
    private final int margin;
    private final int width;
    private final int height;
    private final BitRows bits;
    private final byte[] mask;
    private final int[] column;
    private final int[] half;

    /**
     * Makes operators for grids of {@code cols x rows} cells and discs up to {@code maxRadius} cells.
     *
     * @throws IllegalArgumentException if a side is below 1 or the radius is not finite and at least 0
     */
    public Morphology(int cols, int rows, double maxRadius) {
        if (cols < 1 || rows < 1 || !(maxRadius >= 0) || maxRadius > DistanceTransform.MAX_SIDE) {
            throw new IllegalArgumentException("grid of " + cols + " x " + rows + " cells, disc of radius "
                    + maxRadius + "; needs sides of at least 1 and a radius in [0, " + DistanceTransform.MAX_SIDE
                    + "]");
        }
        this.cols = cols;
        this.rows = rows;
        this.margin = reach(maxRadius) + 1;
        this.width = cols + 2 * margin;
        this.height = rows + 2 * margin;
        this.half = new int[reach(maxRadius) + 1];
        boolean small = reach(maxRadius) <= LARGEST_OF_BITS;
        this.bits = small ? new BitRows(cols, rows, margin) : null;
        this.mask = new byte[small ? 0 : width * height];
        this.column = new int[mask.length];
    }

    /** Sets the cells that lie within {@code radius} cells of a set one. */
    public void dilate(byte[] in, double radius, boolean outside, byte[] out) {
        load(in, outside);
        grow(radius, (byte) 1);
        store(out);
    }

    /** Keeps the cells from which every cell within {@code radius} cells is set. */
    public void erode(byte[] in, double radius, boolean outside, byte[] out) {
        load(in, outside);
        grow(radius, (byte) 0);
        store(out);
    }

    /** Keeps what a disc of {@code radius} cells covers that lies wholly within the set: erodes, then dilates. */
    public void open(byte[] in, double radius, boolean outside, byte[] out) {
        load(in, outside);
        grow(radius, (byte) 0);
        grow(radius, (byte) 1);
        store(out);
    }

    /** Adds what no disc of {@code radius} cells reaches without touching the set: dilates, then erodes. */
    public void close(byte[] in, double radius, boolean outside, byte[] out) {
        load(in, outside);
        grow(radius, (byte) 1);
        grow(radius, (byte) 0);
        store(out);
    }

    private static int reach(double radius) {
        return (int) Math.floor(Math.sqrt(radius * radius + SLACK));
    }

    private void load(byte[] in, boolean outside) {
        if (bits != null) {
            bits.load(in, outside);
            return;
        }
        Arrays.fill(mask, (byte) (outside ? 1 : 0));
        for (int row = 0; row < rows; row++) {
            int to = (row + margin) * width + margin;
            for (int i = row * cols, end = i + cols; i < end; i++, to++) {
                mask[to] = (byte) (in[i] != 0 ? 1 : 0);
            }
        }
    }

    private void store(byte[] out) {
        if (bits != null) {
            bits.store(out);
            return;
        }
        for (int row = 0; row < rows; row++) {
            System.arraycopy(mask, (row + margin) * width + margin, out, row * cols, cols);
        }
    }

    /** Gives {@code value} to every cell of the padded mask within the radius of a cell that has it. */
    private void grow(double radius, byte value) {
        int reach = reach(radius);
        if (!(radius >= 0) || reach >= half.length) {
            throw new IllegalArgumentException(
                    "radius " + radius + " cells; must lie in [0, " + (half.length - 1) + "]");
        }
        for (int d = 0; d <= reach; d++) {
            half[d] = (int) Math.floor(Math.sqrt(radius * radius + SLACK - (double) d * d));
        }
        if (bits != null) {
            bits.grow(reach, half, value != 0);
            return;
        }
        sweepColumns(reach, value);
        for (int row = 0; row < height; row++) {
            sweepRow(row * width, reach, value);
        }
    }

    /** Finds for each cell how far the nearest cell of the value is in its column; above reach: any number. */
    private void sweepColumns(int reach, byte value) {
        int far = reach + 1;
        for (int i = 0; i < width; i++) {
            column[i] = mask[i] == value ? 0 : far;
        }
        for (int i = width; i < mask.length; i++) {
            column[i] = mask[i] == value ? 0 : Math.min(far, column[i - width] + 1);
        }
        for (int i = mask.length - width - 1; i >= 0; i--) {
            column[i] = Math.min(column[i], column[i + width] + 1);
        }
    }

    /** Covers the stretches of one row that the discs of its columns reach, first to the right, then to the left. */
    private void sweepRow(int base, int reach, byte value) {
        int covered = -1;
        for (int x = 0; x < width; x++) {
            int d = column[base + x];
            if (d <= reach) {
                covered = Math.max(covered, x + half[d]);
            }
            if (x <= covered) {
                mask[base + x] = value;
            }
        }
        covered = width;
        for (int x = width - 1; x >= 0; x--) {
            int d = column[base + x];
            if (d <= reach) {
                covered = Math.min(covered, x - half[d]);
            }
            if (x >= covered) {
                mask[base + x] = value;
            }
        }
    }
}
