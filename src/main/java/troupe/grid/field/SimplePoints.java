package troupe.grid.field;

/**
 * Tells from the eight neighbours of a cell whether it can be taken out of a set without changing the
 * topology of the set. Cells of a set are joined by legal steps, and a block of four open cells is filled;
 * so the set is the flag complex of the legal steps, and a cell is simple exactly if its link (its
 * neighbours in the set, joined where they are neighbours) is one arc: not empty, not in pieces and not the
 * full circle.
 *
 * <p>Source: the simple points of digital topology (Kong &amp; Rosenfeld 1989), with (8, 4) adjacency where
 * blocks are open and 4 adjacency at the edge of the region.
 */
final class SimplePoints {
    private static final byte[] TABLE = table();

    private SimplePoints() {}

    /**
     * Tells whether a cell is simple.
     *
     * @param alive the directions with a neighbour in the set, one bit each
     * @param legal the directions with a legal step at all; only its diagonals count: a block of four is
     *     open where they are set
     */
    static boolean isSimple(int alive, int legal) {
        return TABLE[(legal & 0xF0) << 4 | alive & 0xFF] != 0;
    }

    private static byte[] table() {
        byte[] table = new byte[1 << 12];
        for (int i = 0; i < table.length; i++) {
            table[i] = (byte) (linkIsArc(i & 0xFF, i >> 8) ? 1 : 0);
        }
        return table;
    }

    private static boolean linkIsArc(int alive, int blocks) {
        if (alive == 0 || (alive & 0xF) == 0xF && blocks == 0xF) {
            return false;
        }
        int reached = alive & -alive;
        for (int before = 0; before != reached; ) {
            before = reached;
            for (int k = 0; k < 4; k++) {
                int block = alive & (1 << k | 1 << (k + 1 & 3) | 16 << k);
                if ((blocks >> k & 1) != 0 && (block & reached) != 0) {
                    reached |= block;
                }
            }
        }
        return reached == alive;
    }
}
