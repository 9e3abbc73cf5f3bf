package troupe.grid;

/**
 * Computes exact squared Euclidean distances between cell centres, in cells, in linear time: a sweep up
 * and down each column, then the lower envelope of the parabolas of each row, without a division.
 *
 * <p>An instance holds scratch for one grid size and is used by one thread at a time; {@code compute}
 * allocates nothing.
 *
 * <p>Source: Meijster, Roerdink &amp; Hesselink, "A general algorithm for computing distance transforms in
 * linear time" (2000) for the two passes; Maurer, Qi &amp; Raghavan (2003), figure 5, for the test that
 * drops a hidden parabola without finding where two of them cross.
 */
public final class DistanceTransform {
    /** The squared distance where there is no source cell at all. */
    public static final int NONE = Integer.MAX_VALUE;

    /** The most columns or rows, so that squared distances fit an int. */
    public static final int MAX_SIDE = 32_767;

    private final int cols;
    private final int rows;
    private final int[] apex;
    private final int[] height;

    /**
     * Makes a transform for grids of {@code cols x rows} cells.
     *
     * @throws IllegalArgumentException if a side is outside {@code [1, MAX_SIDE]}
     */
    public DistanceTransform(int cols, int rows) {
        if (cols < 1 || rows < 1 || cols > MAX_SIDE || rows > MAX_SIDE) {
            throw new IllegalArgumentException(
                    "grid of " + cols + " x " + rows + " cells; each side must lie in [1, " + MAX_SIDE + "]");
        }
        this.cols = cols;
        this.rows = rows;
        this.apex = new int[cols];
        this.height = new int[cols];
    }

    /**
     * Computes, for each cell, the squared distance in cells to the nearest source cell; 0 on a source.
     *
     * @param sources one byte per cell, row-major; a source where it is not 0
     * @param squared receives the squared distances, row-major; {@link #NONE} everywhere if there is no source
     */
    public void compute(byte[] sources, int[] squared) {
        compute(sources, squared, 0, 0, cols, rows);
    }

    /**
     * Computes the same within a box of cells: sources outside it are not seen, cells outside it not written.
     *
     * @param col0 first column, inclusive
     * @param row0 first row, inclusive
     * @param col1 last column, exclusive
     * @param row1 last row, exclusive
     * @throws IllegalArgumentException if the box is not within the grid
     */
    public void compute(byte[] sources, int[] squared, int col0, int row0, int col1, int row1) {
        if (col0 < 0 || row0 < 0 || col1 > cols || row1 > rows || col0 > col1 || row0 > row1) {
            throw new IllegalArgumentException("box [" + col0 + ", " + col1 + ") x [" + row0 + ", " + row1
                    + ") outside the grid of " + cols + " x " + rows);
        }
        sweepColumns(sources, squared, col0, row0, col1, row1);
        for (int row = row0; row < row1; row++) {
            int count = envelope(squared, row * cols, col0, col1);
            evaluate(squared, row * cols, col0, col1, count);
        }
    }

    /** Leaves in each cell the distance to the nearest source of its column, or {@link #NONE}. */
    private void sweepColumns(byte[] sources, int[] distance, int col0, int row0, int col1, int row1) {
        for (int row = row0; row < row1; row++) {
            int below = row == row0 ? 0 : cols;
            for (int i = row * cols + col0, end = row * cols + col1; i < end; i++) {
                int carried = below == 0 ? NONE : distance[i - cols];
                distance[i] = sources[i] != 0 ? 0 : carried == NONE ? NONE : carried + 1;
            }
        }
        for (int row = row1 - 2; row >= row0; row--) {
            for (int i = row * cols + col0, end = row * cols + col1; i < end; i++) {
                int carried = distance[i + cols];
                if (carried < distance[i]) {
                    distance[i] = carried + 1;
                }
            }
        }
    }

    /** Keeps the parabolas of one row that are lowest somewhere; returns how many. */
    private int envelope(int[] distance, int base, int col0, int col1) {
        int count = 0;
        for (int col = col0; col < col1; col++) {
            int d = distance[base + col];
            if (d == NONE) {
                continue;
            }
            int h = d * d;
            while (count >= 2
                    && hidden(apex[count - 2], height[count - 2], apex[count - 1], height[count - 1], col, h)) {
                count--;
            }
            apex[count] = col;
            height[count++] = h;
        }
        return count;
    }

    /** Tells whether the middle one of three parabolas is nowhere below the other two. */
    private static boolean hidden(int a, long heightA, int b, long heightB, int c, long heightC) {
        long left = b - a;
        long right = c - b;
        long both = left + right;
        return both * heightB - right * heightA - left * heightC - left * right * both > 0;
    }

    private void evaluate(int[] squared, int base, int col0, int col1, int count) {
        if (count == 0) {
            return;
        }
        int k = 0;
        for (int col = col0; col < col1; col++) {
            int best = square(col - apex[k]) + height[k];
            while (k + 1 < count) {
                int next = square(col - apex[k + 1]) + height[k + 1];
                if (next > best) {
                    break;
                }
                best = next;
                k++;
            }
            squared[base + col] = best;
        }
    }

    private static int square(int n) {
        return n * n;
    }
}
