package troupe.grid.region;

import java.util.Arrays;
import java.util.BitSet;
import troupe.grid.GridFrame;

/**
 * Holds the legal neighbours of the configurations for which a mask of directions does not say them all:
 * some spans, and every crossing. One stretch of a list each, ascending by direction, then id. Immutable.
 */
final class TargetLists {
    private final int spanCount;
    private final int spans;
    private final long[] words;
    private final int[] before;
    private final int[] first;
    private int[] target;
    private byte[] direction;

    /** Finds the neighbours of the open spans of a set and of all crossings; cost linear in how many these have. */
    TargetLists(BitSet special, int spanCount, Crossings crossings, Neighbours neighbours, int cells) {
        this.spanCount = spanCount;
        this.words = special.toLongArray();
        this.before = new int[words.length];
        for (int w = 1; w < words.length; w++) {
            before[w] = before[w - 1] + Long.bitCount(words[w - 1]);
        }
        this.spans = special.cardinality();
        this.first = new int[spans + crossings.size() + 1];
        this.target = new int[GridFrame.DIRECTIONS * first.length];
        this.direction = new byte[target.length];
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int slot = 0;
        for (int q = special.nextSetBit(0); q >= 0; q = special.nextSetBit(q + 1)) {
            add(slot++, neighbours.of(q, q % cells, targets, directions), targets, directions);
        }
        for (int i = 0; i < crossings.size(); i++) {
            add(slot++, neighbours.of(spanCount + i, crossings.cell(i), targets, directions), targets, directions);
        }
    }

    private void add(int slot, int count, int[] targets, int[] directions) {
        int from = first[slot];
        if (from + count > target.length) {
            target = Arrays.copyOf(target, 2 * target.length + count);
            direction = Arrays.copyOf(direction, target.length);
        }
        for (int k = 0; k < count; k++) {
            target[from + k] = targets[k];
            direction[from + k] = (byte) directions[k];
        }
        first[slot + 1] = from + count;
    }

    /** Copies the neighbours of a span of the set, or of a crossing; returns how many there are. */
    int of(int q, int[] targets, int[] directions) {
        int slot = q < spanCount ? rank(q) : spans + q - spanCount;
        int from = first[slot];
        int count = first[slot + 1] - from;
        for (int k = 0; k < count; k++) {
            targets[k] = target[from + k];
            directions[k] = direction[from + k];
        }
        return count;
    }

    private int rank(int q) {
        return before[q >> 6] + Long.bitCount(words[q >> 6] & (1L << q) - 1);
    }
}
