package troupe.grid;

import java.util.Arrays;

/**
 * Holds a mask as rows of bits, sixty-four cells to a word, on a plane that is all set or all clear around
 * it, and grows it by discs: each row is widened once for every height of the disc and laid over the rows
 * above and below. Cost O(rows · words · radius), a few operations per word; rows without a set bit cost
 * nothing. One thread at a time; nothing is allocated after construction.
 */
final class BitRows {
    private final int cols;
    private final int rows;
    private final int margin;
    private final int words;
    private final int height;
    private long[] bits;
    private long[] grown;
    private final long[] wide;

    /** Makes rows for masks of {@code cols x rows} cells with {@code margin} cells of the plane on each side. */
    BitRows(int cols, int rows, int margin) {
        this.cols = cols;
        this.rows = rows;
        this.margin = margin;
        this.words = (cols + 2 * margin + 63) / 64;
        this.height = rows + 2 * margin;
        this.bits = new long[words * height];
        this.grown = new long[words * height];
        this.wide = new long[words];
    }

    /** Reads a mask, set where it is not 0; the plane around it is all {@code outside}. */
    void load(byte[] in, boolean outside) {
        Arrays.fill(bits, outside ? -1L : 0);
        for (int row = 0; row < rows; row++) {
            int base = (row + margin) * words;
            int to = margin;
            for (int i = row * cols, end = i + cols; i < end; ) {
                int shift = to & 63;
                int taken = Math.min(64 - shift, end - i);
                long packed = 0;
                for (int k = 0; k < taken; k++) {
                    packed |= (long) (-in[i + k] >>> 31 | in[i + k] >>> 31) << k;
                }
                long changed = (taken == 64 ? -1L : (1L << taken) - 1) << shift;
                int word = base + (to >> 6);
                bits[word] = bits[word] & ~changed | packed << shift;
                i += taken;
                to += taken;
            }
        }
    }

    /** Writes the mask, 0 and 1. */
    void store(byte[] out) {
        for (int row = 0; row < rows; row++) {
            int base = (row + margin) * words;
            for (int i = row * cols, end = i + cols, at = margin; i < end; i++, at++) {
                out[i] = (byte) (bits[base + (at >> 6)] >>> at & 1);
            }
        }
    }

    /**
     * Sets, or clears, every cell within a disc around one that is.
     *
     * @param half for each height from 0 to {@code reach} half the breadth of the disc there, in cells; not increasing
     * @param value whether set cells grow; else clear ones do
     */
    void grow(int reach, int[] half, boolean value) {
        if (!value) {
            complement();
        }
        Arrays.fill(grown, 0);
        for (int row = 0; row < height; row++) {
            if (readRow(row)) {
                int breadth = 0;
                for (int d = reach; d >= 0; d--) {
                    while (breadth < half[d]) {
                        int step = Math.min(Math.min(2 * breadth + 1, half[d] - breadth), 63);
                        widen(step);
                        breadth += step;
                    }
                    lay(row + d);
                    if (d > 0) {
                        lay(row - d);
                    }
                }
            }
        }
        long[] before = bits;
        bits = grown;
        grown = before;
        if (!value) {
            complement();
        }
    }

    private void complement() {
        for (int i = 0; i < bits.length; i++) {
            bits[i] = ~bits[i];
        }
    }

    private boolean readRow(int row) {
        long any = 0;
        for (int w = 0; w < words; w++) {
            wide[w] = bits[row * words + w];
            any |= wide[w];
        }
        return any != 0;
    }

    /** Spreads the bits of the row in hand by {@code step} cells to both sides, {@code 1 <= step <= 63}. */
    private void widen(int step) {
        long before = 0;
        long own = wide[0];
        for (int w = 0; w < words; w++) {
            long after = w + 1 < words ? wide[w + 1] : 0;
            wide[w] = own | own << step | own >>> step | before >>> 64 - step | after << 64 - step;
            before = own;
            own = after;
        }
    }

    private void lay(int row) {
        if (row >= 0 && row < height) {
            int base = row * words;
            for (int w = 0; w < words; w++) {
                grown[base + w] |= wide[w];
            }
        }
    }
}
