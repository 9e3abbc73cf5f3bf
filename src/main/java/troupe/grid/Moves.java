package troupe.grid;

import troupe.scene.Actor;

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

    private Moves() {}

    static byte[] compute(Actor actor, Spans spans, byte[] abilities) {
        byte[] moves = new byte[spans.size()];
        Joints joints = new Joints(actor, spans, abilities);
        GridFrame frame = spans.frame();
        int cols = frame.cols();
        int[] at = spans.columnAt();
        for (int sheet = 0; sheet < spans.sheets(); sheet++) {
            int base = sheet * frame.size();
            for (int row = 1; row < frame.rows() - 1; row++) {
                for (int cell = row * cols + 1, end = cell + cols - 2; cell < end; cell++) {
                    int q = base + cell;
                    if (abilities[q] != 0) {
                        moves[q] = uniform(at, cell, cols)
                                ? LEGAL[around(abilities, q, cols)]
                                : (byte) joints.sameSheet(q, cell);
                    }
                }
            }
        }
        return moves;
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
