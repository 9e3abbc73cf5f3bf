package troupe.grid.region;

/**
 * Walks the straight segment between two cell centres through the cells whose open inside it crosses, in
 * integers. A segment through the common corner of four cells crosses the two it comes from and goes to only.
 */
final class Straight {
    /** Says which cells a segment may pass through. */
    interface Cells {
        /** Tells whether the cell of this index is one of them. */
        boolean hold(int index);
    }

    private Straight() {}

    /**
     * Tells whether every cell between the two ends, the ends left out, is one of {@code cells}, and there
     * is at least one. The begin has index {@code begin}, the end lies {@code dx} columns and {@code dy} rows
     * further, where a row is {@code stride} indices. Cost O(|dx| + |dy|).
     */
    static boolean passes(int begin, int dx, int dy, int stride, Cells cells) {
        long a = Math.abs(dx);
        long b = Math.abs(dy);
        int stepX = dx < 0 ? -1 : 1;
        int stepY = dy < 0 ? -stride : stride;
        int end = begin + dx + dy * stride;
        int at = begin;
        boolean any = false;
        for (long i = 0, j = 0; ; ) {
            long side = (2 * i + 1) * b - (2 * j + 1) * a;
            if (side <= 0) {
                i++;
                at += stepX;
            }
            if (side >= 0) {
                j++;
                at += stepY;
            }
            if (at == end) {
                return any;
            }
            if (!cells.hold(at)) {
                return false;
            }
            any = true;
        }
    }
}
