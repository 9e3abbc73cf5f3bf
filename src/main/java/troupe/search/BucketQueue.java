package troupe.search;

import java.util.Arrays;

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

    private final int shift;
    private final MinHeap[] ring = new MinHeap[BUCKETS];
    private final long[] filled = new long[BUCKETS / Long.SIZE];
    private final MinHeap far = new MinHeap();
    private long reached;
    private long floor;
    private MinHeap current;
    private int size;
    private int added;

    /**
     * Makes an empty queue.
     *
     * @param shift the width of a bucket is {@code 2^shift} units of the key, {@code 0 <= shift < 56}
     */
    public BucketQueue(int shift) {
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
        current = ring[0];
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
            current.insert(key, -cost, number);
        } else if (ahead < BUCKETS) {
            int bucket = (int) (key >>> shift) & MASK;
            filled[bucket >> 6] |= 1L << bucket;
            ring[bucket].append(key, -cost, number);
        } else {
            far.insert(key, -cost, number);
        }
    }

    @Override
    public long firstKey() {
        reach();
        return current.firstKey();
    }

    @Override
    public int removeFirst() {
        reach();
        floor = current.firstKey();
        size--;
        return current.removeFirst();
    }

    /** Goes on to the first bucket that holds anything. A look ahead, too, may pass empty buckets. */
    private void reach() {
        if (!current.isEmpty()) {
            return;
        }
        if (size == 0) {
            throw new IllegalStateException("nothing is open");
        }
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
