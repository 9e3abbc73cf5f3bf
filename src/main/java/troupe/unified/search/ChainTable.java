package troupe.unified.search;

import java.util.Arrays;
import troupe.search.LabelPool;

/**
 * Keeps the first label of each configuration of one search space, in pages that are taken when they are
 * first written, so that a space of which little is searched costs little. A table that is used again clears a
 * page when it is first written in a new generation. Used by one thread at a time.
 */
final class ChainTable {
    private static final int BITS = 9;
    private static final int PAGE = 1 << BITS;
    private static final int WITHIN = PAGE - 1;

    private final int[][] pages;
    private final int[] generations;

    /** Makes the table of {@code size} configurations; none has a label. */
    ChainTable(int size) {
        pages = new int[(size + PAGE - 1) >> BITS][];
        generations = new int[pages.length];
    }

    /** Returns the first label of a configuration, {@link LabelPool#NONE} if it got none in this generation, from 1. */
    int first(int configuration, int generation) {
        int page = configuration >> BITS;
        return generations[page] == generation ? pages[page][configuration & WITHIN] : LabelPool.NONE;
    }

    /** Sets the first label of a configuration. */
    void put(int configuration, int generation, int label) {
        int page = configuration >> BITS;
        if (generations[page] != generation) {
            if (pages[page] == null) {
                pages[page] = new int[PAGE];
            }
            Arrays.fill(pages[page], LabelPool.NONE);
            generations[page] = generation;
        }
        pages[page][configuration & WITHIN] = label;
    }

    /** Forgets everything, whatever the generation; keeps the memory. */
    void clear() {
        Arrays.fill(generations, 0);
    }
}
