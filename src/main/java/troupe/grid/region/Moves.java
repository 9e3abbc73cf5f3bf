package troupe.grid.region;

import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.layer.Spans;
import troupe.grid.region.ground.Words;

/**
 * Finds the legal steps between spans of the same sheet, one bit per direction, and which spans have others.
 * Where the nine columns around a cell are the same, the steps follow from which of the nine spans are open, by
 * a table; elsewhere the spans are joined one by one. What it finds goes into the words.
 */
final class Moves {
    /** Legal directions for each mask of nine open places: columns from the left, in each from below. */
    private static final byte[] LEGAL = new byte[512];

    /** Set in a {@link #triple} where the three columns are the same. */
    private static final int SAME = 8;

    static {
        for (int mask = 0; mask < LEGAL.length; mask++) {
            int legal = 0;
            for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                boolean open = open(mask, d);
                if (d >= 4) {
                    open &= open(mask, d - 4) && open(mask, d - 3 & 3);
                }
                legal |= open ? 1 << d : 0;
            }
            LEGAL[mask] = (byte) legal;
        }
    }

    private final Spans spans;
    private final Words words;
    private final Joints joints;
    private final int[] at;
    private final int[] offsets;
    private final int cells;
    private final int cols;

    Moves(Spans spans, Words words, Joints joints) {
        this.spans = spans;
        this.words = words;
        this.joints = joints;
        this.at = spans.columnAt();
        this.offsets = spans.frame().offsets();
        this.cells = spans.frame().size();
        this.cols = spans.frame().cols();
    }

    private static boolean open(int mask, int d) {
        return (mask >> 3 * (GridFrame.dx(d) + 1) + GridFrame.dy(d) + 1 & 1) != 0;
    }

    /** Finds the steps of the spans over a window of cells anew, those to crossings left out. Cost O(spans there). */
    void compute(Window window) {
        Window inner = window.common(new Window(1, 1, cols - 2, spans.frame().rows() - 2));
        char[][] rows = new char[3][inner.cols() + 2];
        char[] found = new char[inner.cols()];
        for (int sheet = 0; sheet < spans.sheets(); sheet++) {
            int q = sheet * cells + (inner.row0() - 1) * cols + inner.col0() - 1;
            words.read(q, inner.cols() + 2, rows[0]);
            words.read(q + cols, inner.cols() + 2, rows[1]);
            for (int row = 0; row < inner.rows(); row++) {
                q += cols;
                char[] below = rows[row % 3];
                char[] own = rows[(row + 1) % 3];
                char[] above = rows[(row + 2) % 3];
                words.read(q + cols, inner.cols() + 2, above);
                row(q + 1, (inner.row0() + row) * cols + inner.col0(), below, own, above, found);
                words.write(q + 1, inner.cols(), found);
            }
        }
    }

    /** Finds the words of a row of spans from {@code first} on, of which three rows are given with one more each side. */
    private void row(int first, int firstCell, char[] below, char[] own, char[] above, char[] found) {
        int left = triple(firstCell - 1, below[0], own[0], above[0]);
        int middle = triple(firstCell, below[1], own[1], above[1]);
        for (int i = 0; i < found.length; i++) {
            int cell = firstCell + i;
            int right = triple(cell + 1, below[i + 2], own[i + 2], above[i + 2]);
            int word = own[i + 1] & 0xff & ~(Words.SPECIAL | Words.ELSEWHERE);
            if ((word & Words.STANDING) != 0) {
                boolean uniform =
                        (left & middle & right & SAME) != 0 && at[cell - 1] == at[cell] && at[cell + 1] == at[cell];
                word |= uniform
                        ? (LEGAL[left & 7 | (middle & 7) << 3 | (right & 7) << 6] & 0xff) << Words.MOVES
                        : single(first + i, cell);
            }
            found[i] = (char) word;
            left = middle;
            middle = right;
        }
    }

    /** Returns which of a cell and those below and above it are open, from below, and whether columns are the same. */
    private int triple(int cell, int below, int own, int above) {
        return open(below)
                | open(own) << 1
                | open(above) << 2
                | (at[cell - cols] == at[cell] && at[cell + cols] == at[cell] ? SAME : 0);
    }

    /** Returns 1 for the word of an open span, 0 for another, without a branch. */
    private static int open(int word) {
        return -(word & Words.STANDING) >>> 31;
    }

    private int single(int q, int cell) {
        int bits = 0;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            int target = joints.legal(q, cell, d);
            if (target == q + offsets[d]) {
                bits |= 1 << Words.MOVES + d;
            } else if (target >= 0) {
                bits |= Words.SPECIAL | Words.ELSEWHERE;
            }
        }
        return bits;
    }
}
