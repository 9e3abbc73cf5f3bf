package troupe.search;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Keeps open items in a 4-ary heap. Adding and removing cost O(log n); keys may come in any order.
 *
 * <p>An entry is three longs side by side: the key, the negated cost, and the insertion number above the
 * item, so that one comparison of three numbers settles every tie and one cache line holds an entry.
 */
public final class MinHeap implements OpenList {
    private static final int WORDS = 3;
    private static final int ITEM_BITS = 32;

    private long[] entries;
    private int size;
    private int added;

    /** Makes an empty heap. */
    public MinHeap() {
        this(16);
    }

    /** Makes an empty heap with room for {@code capacity} entries, at least 1, before it grows. */
    public MinHeap(int capacity) {
        if (capacity < 1) {
            throw new IllegalArgumentException("capacity=" + capacity + "; needs at least 1");
        }
        entries = new long[capacity * WORDS];
    }

    @Override
    public void clear() {
        size = 0;
        added = 0;
    }

    @Override
    public boolean isEmpty() {
        return size == 0;
    }

    @Override
    public int size() {
        return size;
    }

    @Override
    public void add(int item, long key, long cost) {
        insert(key, -cost, number(added++, item));
    }

    @Override
    public long firstKey() {
        if (size == 0) {
            throw new IllegalStateException("nothing is open");
        }
        return entries[0];
    }

    @Override
    public int removeFirst() {
        if (size == 0) {
            throw new IllegalStateException("nothing is open");
        }
        int item = (int) entries[2];
        size--;
        if (size > 0) {
            int last = size * WORDS;
            siftDown(0, entries[last], entries[last + 1], entries[last + 2]);
        }
        return item;
    }

    /** Joins an insertion number and an item into the third word of an entry. */
    static long number(int insertion, int item) {
        return ((long) insertion << ITEM_BITS) | item;
    }

    /** Adds an entry given as its three words and restores the order. */
    void insert(long key, long tie, long number) {
        int at = grown();
        while (at > 0) {
            int parent = (at - 1) >> 2;
            int p = parent * WORDS;
            if (!precedes(key, tie, number, p)) {
                break;
            }
            move(p, at * WORDS);
            at = parent;
        }
        set(at * WORDS, key, tie, number);
    }

    /** Adds an entry given as its three words without ordering it; {@link #heapify} must follow. */
    void append(long key, long tie, long number) {
        set(grown() * WORDS, key, tie, number);
    }

    /** Tells whether the first entry of a heap that is not empty comes after a key and a tie. */
    boolean isAfter(long key, long tie) {
        return key < entries[0] || key == entries[0] && tie < entries[1];
    }

    /** Drops the items that are outdated, unordered, and returns how many; {@link #heapify} must follow. */
    int drop(IntPredicate outdated) {
        int kept = 0;
        for (int at = 0; at < size; at++) {
            int a = at * WORDS;
            if (!outdated.test((int) entries[a + 2])) {
                move(a, kept++ * WORDS);
            }
        }
        int dropped = size - kept;
        size = kept;
        return dropped;
    }

    /** Orders what was appended, in O(n). */
    void heapify() {
        for (int at = (size - 2) >> 2; at >= 0; at--) {
            int a = at * WORDS;
            siftDown(at, entries[a], entries[a + 1], entries[a + 2]);
        }
    }

    /** Moves the first entry to another heap, unordered there. */
    void moveFirstTo(MinHeap other) {
        other.append(entries[0], entries[1], entries[2]);
        removeFirst();
    }

    private int grown() {
        if ((size + 1) * WORDS > entries.length) {
            entries = Arrays.copyOf(entries, Math.max((size + 1) * WORDS, 2 * entries.length));
        }
        return size++;
    }

    private void siftDown(int from, long key, long tie, long number) {
        int at = from;
        int child = 4 * at + 1;
        while (child < size) {
            int least = child * WORDS;
            int end = Math.min(child + 4, size) * WORDS;
            for (int c = least + WORDS; c < end; c += WORDS) {
                if (precedes(entries[c], entries[c + 1], entries[c + 2], least)) {
                    least = c;
                }
            }
            if (precedes(key, tie, number, least)) {
                break;
            }
            move(least, at * WORDS);
            at = least / WORDS;
            child = 4 * at + 1;
        }
        set(at * WORDS, key, tie, number);
    }

    private boolean precedes(long key, long tie, long number, int other) {
        long otherKey = entries[other];
        if (key != otherKey) {
            return key < otherKey;
        }
        long otherTie = entries[other + 1];
        return tie != otherTie ? tie < otherTie : number < entries[other + 2];
    }

    private void move(int from, int to) {
        entries[to] = entries[from];
        entries[to + 1] = entries[from + 1];
        entries[to + 2] = entries[from + 2];
    }

    private void set(int at, long key, long tie, long number) {
        entries[at] = key;
        entries[at + 1] = tie;
        entries[at + 2] = number;
    }
}
