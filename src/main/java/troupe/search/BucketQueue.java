package troupe.search;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Keeps open items in a ring of buckets, each as wide as a power of two: an exact monotone queue. A
 * bucket only collects until it is reached; then it becomes a small heap, so the order is that of
 * {@link MinHeap} to the last tie. Keys too far ahead for the ring wait in a heap of their own.
 *
 * <p>Monotone: a key below the one removed last is refused. Adding costs O(1) unless it hits the bucket
 * being emptied; removing costs O(log b) for b entries in a bucket.
 *
 * <p>Source: Dial 1969 and Denardo and Fox 1979, with a heap inside the bucket that is being emptied so
 * that no order is lost by rounding.
 */
public final class BucketQueue implements OpenList {
    private static final int BUCKETS = 256;
    private static final int MASK = BUCKETS - 1;

    private final IntPredicate outdated;
    private final int shift;
    private final MinHeap[] ring = new MinHeap[BUCKETS];
    private final long[] filled = new long[BUCKETS / Long.SIZE];
    private final MinHeap far = new MinHeap();
    private long reached;
    private long floor;
    private MinHeap current;

    /** An entry before all others, kept out of the heap: a search often takes next what it added last. */
    private boolean hasNext;

    private long nextKey;
    private long nextTie;
    private long nextNumber;
    private int size;
    private int added;

    /**
     * Makes an empty queue.
     *
     * @param shift the width of a bucket is {@code 2^shift} units of the key, {@code 0 <= shift < 56}
     */
    public BucketQueue(int shift) {
        this(shift, item -> false);
    }

    /**
     * Makes an empty queue that drops, when it reaches a bucket, the items in it that are outdated: those
     * which the search would skip. They are never handed out; the order of the others stays.
     *
     * @param shift the width of a bucket is {@code 2^shift} units of the key, {@code 0 <= shift < 56}
     * @param outdated tells whether an item would be skipped; once it holds, it must go on to hold
     */
    public BucketQueue(int shift, IntPredicate outdated) {
        this.outdated = outdated;
        if (shift < 0 || shift >= 56) {
            throw new IllegalArgumentException("shift=" + shift + "; needs 0 to 55");
        }
        this.shift = shift;
        Arrays.setAll(ring, i -> new MinHeap(8));
        current = ring[0];
    }

    @Override
    public void clear() {
        for (MinHeap bucket : ring) {
            bucket.clear();
        }
        Arrays.fill(filled, 0);
        far.clear();
        reached = 0;
        floor = 0;
        hasNext = false;
        current = ring[0];
        size = 0;
        added = 0;
    }

    @Override
    public boolean isEmpty() {
        return !hasNext && !reach();
    }

    /** {@inheritDoc} Items that are outdated count until their bucket is reached. */
    @Override
    public int size() {
        return size;
    }

    /**
     * {@inheritDoc}
     *
     * @throws IllegalArgumentException if the key is below the one removed last
     */
    @Override
    public void add(int item, long key, long cost) {
        if (key < floor) {
            throw new IllegalArgumentException("key=" + key + "; needs at least " + floor + ", the key removed last");
        }
        long ahead = (key >>> shift) - reached;
        long number = MinHeap.number(added++, item);
        size++;
        if (ahead <= 0) {
            addReached(key, -cost, number);
        } else if (ahead < BUCKETS) {
            int bucket = (int) (key >>> shift) & MASK;
            filled[bucket >> 6] |= 1L << bucket;
            ring[bucket].append(key, -cost, number);
        } else {
            far.insert(key, -cost, number);
        }
    }

    /** Adds an entry to the bucket being emptied, or keeps it apart if it goes before all others. */
    private void addReached(long key, long tie, long number) {
        if (ahead(key, tie)) {
            if (hasNext) {
                current.insert(nextKey, nextTie, nextNumber);
            }
            hasNext = true;
            nextKey = key;
            nextTie = tie;
            nextNumber = number;
        } else {
            current.insert(key, tie, number);
        }
    }

    private boolean ahead(long key, long tie) {
        if (hasNext) {
            return key < nextKey || key == nextKey && tie < nextTie;
        }
        return current.isEmpty() || current.isAfter(key, tie);
    }

    @Override
    public long firstKey() {
        if (isEmpty()) {
            throw new IllegalStateException("nothing is open");
        }
        return hasNext ? nextKey : current.firstKey();
    }

    @Override
    public int removeFirst() {
        floor = firstKey();
        size--;
        if (hasNext) {
            hasNext = false;
            return (int) nextNumber;
        }
        return current.removeFirst();
    }

    /** Goes on to the first bucket that holds anything, and tells whether there is one. */
    private boolean reach() {
        while (current.isEmpty()) {
            if (size == 0) {
                return false;
            }
            reachNext();
        }
        return true;
    }

    /** Goes on to the next filled bucket; a look ahead, too, may pass empty ones. */
    private void reachNext() {
        int ahead = nextFilled();
        long next = ahead > 0 ? reached + ahead : Long.MAX_VALUE;
        reached = far.isEmpty() ? next : Math.min(next, far.firstKey() >>> shift);
        while (!far.isEmpty() && (far.firstKey() >>> shift) - reached < BUCKETS) {
            int bucket = (int) (far.firstKey() >>> shift) & MASK;
            filled[bucket >> 6] |= 1L << bucket;
            far.moveFirstTo(ring[bucket]);
        }
        int bucket = (int) reached & MASK;
        filled[bucket >> 6] &= ~(1L << bucket);
        current = ring[bucket];
        size -= current.drop(outdated);
        current.heapify();
    }

    /** Returns how many buckets ahead the next filled one lies, 1 to 255, or 0 if the ring is empty. */
    private int nextFilled() {
        int first = ((int) reached + 1) & MASK;
        long word = filled[first >> 6] & (-1L << first);
        int base = first & -Long.SIZE;
        for (int i = 0; i <= filled.length; i++) {
            if (word != 0) {
                int bucket = (base & MASK) + Long.numberOfTrailingZeros(word);
                return (bucket - (int) reached) & MASK;
            }
            base += Long.SIZE;
            word = filled[(base & MASK) >> 6];
        }
        return 0;
    }
}
