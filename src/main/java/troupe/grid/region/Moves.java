package troupe.grid.region;

import java.util.BitSet;
import troupe.grid.GridFrame;
import troupe.grid.layer.Spans;

/**
 * Finds the legal steps between spans of the same sheet, one bit per direction. Where the nine columns
 * around a cell are the same, the steps follow from which of the nine spans are open, by a table; elsewhere
 * the spans are joined one by one.
 */
final class Moves {
    /** Legal directions for each mask of open neighbours: a diagonal needs both its straight neighbours. */
    private static final byte[] LEGAL = new byte[256];

    static {
        for (int mask = 0; mask < 256; mask++) {
            int legal = mask & 15;
            for (int d = 4; d < 8; d++) {
                int straight = 1 << d - 4 | 1 << (d - 3 & 3);
                if ((mask >> d & 1) != 0 && (mask & straight) == straight) {
                    legal |= 1 << d;
                }
            }
            LEGAL[mask] = (byte) legal;
        }
    }

    private final Spans spans;
    private final byte[] abilities;
    private final Joints joints;
    private final int[] offsets;
    private final byte[] moves;
    private final BitSet elsewhere;

    Moves(Spans spans, byte[] abilities, Joints joints) {
        this.spans = spans;
        this.abilities = abilities;
        this.joints = joints;
        this.offsets = spans.frame().offsets();
        this.moves = new byte[abilities.length];
        this.elsewhere = new BitSet();
    }

    /** Finds the steps of every open span. Cost O(spans). */
    void compute() {
        GridFrame frame = spans.frame();
        int cols = frame.cols();
        int[] at = spans.columnAt();
        for (int sheet = 0; sheet < spans.sheets(); sheet++) {
            int base = sheet * frame.size();
            for (int row = 1; row < frame.rows() - 1; row++) {
                for (int cell = row * cols + 1, end = cell + cols - 2; cell < end; cell++) {
                    int q = base + cell;
                    if (abilities[q] == 0) {
                        continue;
                    }
                    if (uniform(at, cell, cols)) {
                        moves[q] = LEGAL[around(abilities, q, cols)];
                    } else {
                        single(q, cell);
                    }
                }
            }
        }
    }

    private void single(int q, int cell) {
        int mask = 0;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            int target = joints.legal(q, cell, d);
            if (target == q + offsets[d]) {
                mask |= 1 << d;
            } else if (target >= 0) {
                elsewhere.set(q);
            }
        }
        moves[q] = (byte) mask;
    }

    /** Returns the directions of each configuration's steps on its own sheet; the array itself. */
    byte[] moves() {
        return moves;
    }

    /** Returns the spans that have a step to another sheet; the set itself. */
    BitSet elsewhere() {
        return elsewhere;
    }

    private static boolean uniform(int[] at, int cell, int cols) {
        int id = at[cell];
        return at[cell - 1] == id
                && at[cell + 1] == id
                && at[cell - cols - 1] == id
                && at[cell - cols] == id
                && at[cell - cols + 1] == id
                && at[cell + cols - 1] == id
                && at[cell + cols] == id
                && at[cell + cols + 1] == id;
    }

    private static int around(byte[] abilities, int q, int cols) {
        return bit(abilities[q + 1], 0)
                | bit(abilities[q + cols], 1)
                | bit(abilities[q - 1], 2)
                | bit(abilities[q - cols], 3)
                | bit(abilities[q + cols + 1], 4)
                | bit(abilities[q + cols - 1], 5)
                | bit(abilities[q - cols - 1], 6)
                | bit(abilities[q - cols + 1], 7);
    }

    /** Moves "not 0" of a small non-negative number to a bit without a branch. */
    private static int bit(int abilities, int d) {
        return (-abilities >>> 31) << d;
    }
}
