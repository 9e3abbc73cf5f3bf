package troupe.unified.search;

import java.util.Arrays;
import troupe.search.LabelPool;

/**
 * Keeps the first label of each configuration of one search space, in pages that are taken when they are
 * first written, so that a space of which little is searched costs little. A generation stamp takes the place
 * of clearing. Used by one thread at a time.
 */
final class ChainTable {
    private static final int BITS = 9;
    private static final int PAGE = 1 << BITS;
    private static final int WITHIN = PAGE - 1;

    private final int[][] first;
    private final int[][] stamps;

    /** Makes the table of {@code size} configurations; none has a label. */
    ChainTable(int size) {
        first = new int[(size + PAGE - 1) >> BITS][];
        stamps = new int[first.length][];
    }

    /** Returns the first label of a configuration, {@link LabelPool#NONE} if it got none in this generation. */
    int first(int configuration, int generation) {
        int[] page = stamps[configuration >> BITS];
        return page == null || page[configuration & WITHIN] != generation
                ? LabelPool.NONE
                : first[configuration >> BITS][configuration & WITHIN];
    }

    /** Sets the first label of a configuration. */
    void put(int configuration, int generation, int label) {
        int number = configuration >> BITS;
        if (stamps[number] == null) {
            stamps[number] = new int[PAGE];
            first[number] = new int[PAGE];
        }
        stamps[number][configuration & WITHIN] = generation;
        first[number][configuration & WITHIN] = label;
    }

    /** Forgets everything, whatever the generation; keeps the memory. */
    void clear() {
        for (int[] page : stamps) {
            if (page != null) {
                Arrays.fill(page, 0);
            }
        }
    }
}
