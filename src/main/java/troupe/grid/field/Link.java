package troupe.grid.field;

import troupe.grid.GridFrame;

/**
 * Holds the neighbours of one node within a set and tells whether the node can be taken out of the set
 * without changing its topology, when the direction mask alone does not say: the general form of
 * {@link SimplePoints}. The node is simple if its link folds to a point, neighbour by neighbour, each next to
 * another one that is next to all that it is next to; for the links of flat places that is the same.
 */
final class Link {
    private static final int LARGEST = 64;

    private final StepGraph graph;
    private final int[] member = new int[LARGEST];
    private final int[] heading = new int[LARGEST];
    private final long[] adjacent = new long[LARGEST];
    private int count;

    Link(StepGraph graph) {
        this.graph = graph;
    }

    /** Collects the neighbours of a node that have a bit in their state; returns how many. */
    int collect(int q, byte[] state, int bit) {
        count = 0;
        int s = graph.slot == null ? -1 : graph.slot[q];
        if (s < 0) {
            for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                if ((graph.moves[q] >> d & 1) != 0) {
                    add(q + graph.offset[d], d, state, bit);
                }
            }
        } else {
            for (int k = graph.first[s]; k < graph.first[s + 1] && count < LARGEST; k++) {
                add(graph.target[k], graph.direction[k], state, bit);
            }
        }
        return count;
    }

    /** Returns how many neighbours were collected last. */
    int count() {
        return count;
    }

    /** Returns one of the collected neighbours, {@code 0 <= k < collect(...)}. */
    int member(int k) {
        return member[k];
    }

    /** Returns the direction of one of the collected neighbours. */
    int heading(int k) {
        return heading[k];
    }

    private void add(int q, int d, byte[] state, int bit) {
        if ((state[q] & bit) != 0) {
            member[count] = q;
            heading[count++] = d;
        }
    }

    /** Tells whether the collected neighbours fold to a point; not if there are too many to look at. */
    boolean foldsToPoint() {
        if (count == 0 || count == LARGEST) {
            return false;
        }
        connect();
        long rest = (1L << count) - 1;
        boolean folding = true;
        while (folding && Long.bitCount(rest) > 1) {
            folding = false;
            for (int k = 0; k < count && !folding; k++) {
                if ((rest >> k & 1) != 0 && dominated(k, rest)) {
                    rest &= ~(1L << k);
                    folding = true;
                }
            }
        }
        return Long.bitCount(rest) == 1;
    }

    private boolean dominated(int k, long rest) {
        long own = (adjacent[k] | 1L << k) & rest;
        for (long others = adjacent[k] & rest; others != 0; others &= others - 1) {
            int other = Long.numberOfTrailingZeros(others);
            if ((own & ~(adjacent[other] | 1L << other)) == 0) {
                return true;
            }
        }
        return false;
    }

    private void connect() {
        for (int k = 0; k < count; k++) {
            adjacent[k] = 0;
            for (int other = 0; other < k; other++) {
                int d = direction(
                        GridFrame.dx(heading[other]) - GridFrame.dx(heading[k]),
                        GridFrame.dy(heading[other]) - GridFrame.dy(heading[k]));
                if (d >= 0 && graph.has(member[k], d, member[other])) {
                    adjacent[k] |= 1L << other;
                    adjacent[other] |= 1L << k;
                }
            }
        }
    }

    private static int direction(int dx, int dy) {
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            if (GridFrame.dx(d) == dx && GridFrame.dy(d) == dy) {
                return d;
            }
        }
        return -1;
    }
}
