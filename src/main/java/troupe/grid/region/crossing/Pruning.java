package troupe.grid.region.crossing;

import java.util.Arrays;
import troupe.grid.GridFrame;

/**
 * Keeps of a mask of candidates those that some legal straight crossing passes: from a begin to an end
 * no further apart than a limit, through candidates only. Crossings along rows, columns and diagonals are
 * tried first, because they keep nearly everything; then, while candidates are left, every pair of ends
 * that candidates touch.
 */
public final class Pruning {
    /** Marks a candidate. */
    static final int CANDIDATE = 1;

    /** Marks a cell where a crossing may end. */
    static final int END = 2;

    /** Marks a cell where a crossing may begin. */
    static final int BEGIN = 4;

    private static final int KEPT = 8;
    private static final int LISTED = 16;

    private final int cols;
    private final int rows;
    private final int words;
    private final byte[] state;
    private int left;
    private int[] sums = {};
    private int[] endCols = {};
    private int[] endRows = {};
    private long[] endBits = {};

    Pruning(int cols, int rows, byte[] state) {
        this.cols = cols;
        this.rows = rows;
        this.words = cols + 63 >> 6;
        this.state = state;
    }

    /** Returns the greatest squared distance in cells of a crossing of at most {@code limit} metres. */
    public static double squaredCells(double limit, double cell) {
        double reach = (limit + 1e-9) / cell;
        return reach * reach;
    }

    /** Returns a mask of the candidates that lie on a crossing of at most the given squared length in cells. */
    byte[] kept(double squared) {
        int reach = (int) Math.floor(Math.sqrt(squared));
        int[] ends = ends();
        for (int e : ends) {
            if ((state[e] & BEGIN) != 0) {
                alongDirections(e, squared);
            }
        }
        if (left > 0) {
            countLeft();
            unpack(ends);
            int[] across = new int[reach + 1];
            for (int dy = 0; dy <= reach; dy++) {
                across[dy] = (int) Math.sqrt(squared - (double) dy * dy);
            }
            for (int n = 0; n < ends.length; n++) {
                if (left > 0 && (state[ends[n]] & BEGIN) != 0 && anyLeft(endCols[n], endRows[n], reach)) {
                    toEnds(n, reach, across);
                }
            }
        }
        byte[] kept = new byte[state.length];
        for (int i = 0; i < kept.length; i++) {
            kept[i] = (byte) (state[i] >> 3 & 1);
        }
        return kept;
    }

    /** Counts the candidates and returns the ascending cells of ends that have one among their eight neighbours. */
    private int[] ends() {
        int[] list = new int[64];
        int count = 0;
        for (int i = 0; i < state.length; i++) {
            if ((state[i] & CANDIDATE) == 0) {
                continue;
            }
            left++;
            int col = i % cols;
            int row = i / cols;
            for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                int x = col + GridFrame.dx(d);
                int y = row + GridFrame.dy(d);
                if (is(x, y, END) && !is(x, y, LISTED)) {
                    if (count == list.length) {
                        list = Arrays.copyOf(list, 2 * count);
                    }
                    state[y * cols + x] |= LISTED;
                    list[count++] = y * cols + x;
                }
            }
        }
        int[] ends = Arrays.copyOf(list, count);
        Arrays.sort(ends);
        return ends;
    }

    /** Sums, for each corner of the cells, the candidates below and left of it that are not kept yet. */
    private void countLeft() {
        sums = new int[(cols + 1) * (rows + 1)];
        for (int row = 0; row < rows; row++) {
            int inRow = 0;
            for (int col = 0; col < cols; col++) {
                inRow += (state[row * cols + col] & (CANDIDATE | KEPT)) == CANDIDATE ? 1 : 0;
                sums[(row + 1) * (cols + 1) + col + 1] = sums[row * (cols + 1) + col + 1] + inRow;
            }
        }
    }

    /** Tells whether a candidate was left, when last counted, within {@code reach} columns and rows of a cell. */
    private boolean anyLeft(int col, int row, int reach) {
        return anyLeft(col - reach, row - reach, col + reach, row + reach);
    }

    private boolean anyLeft(int col0, int row0, int col1, int row1) {
        int left = Math.max(0, col0);
        int low = Math.max(0, row0);
        int right = Math.min(cols, col1 + 1);
        int high = Math.min(rows, row1 + 1);
        int wide = cols + 1;
        return sums[high * wide + right] - sums[high * wide + left] - sums[low * wide + right] + sums[low * wide + left]
                > 0;
    }

    private boolean is(int col, int row, int flag) {
        return col >= 0 && row >= 0 && col < cols && row < rows && (state[row * cols + col] & flag) != 0;
    }

    /** Keeps what the crossings from one begin along the eight directions pass. */
    private void alongDirections(int begin, double squared) {
        int col = begin % cols;
        int row = begin / cols;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            int each = d < 4 ? 1 : 2;
            int last = 0;
            for (int n = 1; (double) n * n * each <= squared; n++) {
                int x = col + n * GridFrame.dx(d);
                int y = row + n * GridFrame.dy(d);
                if (is(x, y, END)) {
                    last = n;
                }
                if (!is(x, y, CANDIDATE)) {
                    break;
                }
            }
            for (int n = 1; n < last; n++) {
                keep((row + n * GridFrame.dy(d)) * cols + col + n * GridFrame.dx(d));
            }
        }
    }

    private void keep(int i) {
        if ((state[i] & KEPT) == 0) {
            state[i] |= KEPT;
            left--;
        }
    }

    /** Keeps what the segment from a begin to an end passes, if that is candidates only. */
    private void keepBetween(int begin, int dx, int dy) {
        Straight line = new Straight(begin, dx, dy, cols);
        int common = CANDIDATE | KEPT;
        while (line.next()) {
            int passed = state[line.at()];
            if ((passed & CANDIDATE) == 0) {
                return;
            }
            common &= passed;
        }
        if ((common & KEPT) == 0) {
            line = new Straight(begin, dx, dy, cols);
            while (line.next()) {
                keep(line.at());
            }
        }
    }

    /** Keeps what the crossings from one begin to all ends within reach pass, begins tried before left out. */
    private void toEnds(int begin, int reach, int[] across) {
        int row = endRows[begin];
        for (int y = Math.max(0, row - reach), high = Math.min(rows - 1, row + reach); y <= high; y++) {
            toEndsOfRow(begin, y, across[Math.abs(y - row)]);
        }
    }

    private void toEndsOfRow(int begin, int y, int across) {
        int col = endCols[begin];
        int row = endRows[begin];
        int low = Math.min(row, y);
        int high = Math.max(row, y);
        int last = Math.min(cols - 1, col + across);
        if (!anyLeft(col - across, low, col + across, high)) {
            return;
        }
        for (int x = nextEnd(y, Math.max(0, col - across)); x <= last; x = nextEnd(y, x + 1)) {
            boolean tried = (y < row || y == row && x <= col) && (state[y * cols + x] & BEGIN) != 0;
            if (!tried && anyLeft(Math.min(col, x), low, Math.max(col, x), high)) {
                keepBetween(row * cols + col, x - col, y - row);
            }
        }
    }

    /** Returns the first column from {@code col} on that holds an end in a row, {@code cols} or more if none does. */
    private int nextEnd(int row, int col) {
        for (int w = col >> 6; w < words; w++) {
            long bits = endBits[row * words + w];
            bits &= w == col >> 6 ? -1L << col : -1L;
            if (bits != 0) {
                return w << 6 | Long.numberOfTrailingZeros(bits);
            }
        }
        return words << 6;
    }

    /** Unpacks the cells of the ends, so that pairs are found without divisions. */
    private void unpack(int[] ends) {
        endCols = new int[ends.length];
        endRows = new int[ends.length];
        endBits = new long[rows * words];
        for (int n = 0; n < ends.length; n++) {
            endRows[n] = ends[n] / cols;
            endCols[n] = ends[n] - endRows[n] * cols;
            endBits[endRows[n] * words + (endCols[n] >> 6)] |= 1L << endCols[n];
        }
    }
}
