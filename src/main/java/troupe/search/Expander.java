package troupe.search;

/** Says what a best-first search does with the item it takes from the open list. */
public interface Expander {

    /** What became of an item. */
    enum Verdict {
        /** Its successors were added; this counts as one expansion. */
        EXPANDED,
        /** It was out of date, or was put back with a larger key; this costs nothing. */
        SKIPPED,
        /** It is what was looked for; this counts as one expansion and ends the search. */
        GOAL,
        /** It waits for something outside of the loop, which pauses; this costs nothing. */
        WAITING
    }

    /**
     * Takes the first open item and adds what follows from it to the open list.
     *
     * @param item what was added to the open list
     * @param key the key under which it stood there
     */
    Verdict expand(int item, long key);
}
