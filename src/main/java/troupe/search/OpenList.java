package troupe.search;

/**
 * Keeps the open items of a best-first search in order: least key first, among equal keys the larger
 * cost so far, among equal costs the one added first. Every implementation hands out the same items in
 * the same order. Items are whole numbers from 0; one item may be in the list several times. Used by one
 * thread at a time.
 */
public interface OpenList {

    /** Empties the list and starts the insertion numbers anew; keeps the memory. */
    void clear();

    /** Tells whether nothing is open. */
    boolean isEmpty();

    /** Returns the number of entries. */
    int size();

    /**
     * Adds an item.
     *
     * @param item a number from 0
     * @param key what orders the list, from 0; a monotone list may demand that it is not below the key
     *     removed last
     * @param cost the cost so far, from 0
     */
    void add(int item, long key, long cost);

    /**
     * Returns the key of the first entry.
     *
     * @throws IllegalStateException if the list is empty
     */
    long firstKey();

    /**
     * Removes the first entry and returns its item.
     *
     * @throws IllegalStateException if the list is empty
     */
    int removeFirst();
}
