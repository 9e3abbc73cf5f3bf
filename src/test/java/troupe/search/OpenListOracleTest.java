package troupe.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares both open lists, entry by entry, with a plain list that is searched for its first entry. */
class OpenListOracleTest {
    private record Entry(long key, long cost, int number, int item) {}

    private static final Comparator<Entry> ORDER = Comparator.comparingLong(Entry::key)
            .thenComparing(Comparator.comparingLong(Entry::cost).reversed())
            .thenComparingInt(Entry::number);

    @ParameterizedTest
    @ValueSource(ints = {0, 3, 7, 12})
    void heapAndBucketsHandOutTheOrderOfThePlainList(int shift) {
        for (long seed = 1; seed <= 60; seed++) {
            compare(seed, shift);
        }
    }

    private static void compare(long seed, int shift) {
        Random random = new Random(seed);
        MinHeap heap = new MinHeap(1);
        BucketQueue buckets = new BucketQueue(shift);
        for (int round = 0; round < 2; round++) {
            heap.clear();
            buckets.clear();
            List<Entry> plain = new ArrayList<>();
            long floor = 0;
            int reach = random.nextInt(4) == 0 ? 1_000_000 : 1 << random.nextInt(12);
            for (int i = 0; i < 600; i++) {
                if (plain.isEmpty() || random.nextInt(5) < 3 && i < 450) {
                    Entry entry = new Entry(floor + random.nextInt(reach), random.nextInt(5), i, random.nextInt(99));
                    plain.add(entry);
                    heap.add(entry.item, entry.key, entry.cost);
                    buckets.add(entry.item, entry.key, entry.cost);
                } else {
                    Entry first = plain.stream().min(ORDER).orElseThrow();
                    plain.remove(first);
                    floor = first.key;
                    String at = "seed " + seed + ", shift " + shift + ", step " + i;
                    assertEquals(first.key, heap.firstKey(), at);
                    assertEquals(first.key, buckets.firstKey(), at);
                    assertEquals(first.item, heap.removeFirst(), at);
                    assertEquals(first.item, buckets.removeFirst(), at);
                }
                assertEquals(plain.size(), heap.size());
                assertEquals(plain.size(), buckets.size());
            }
        }
    }

    @Test
    void bucketsTakeKeysBelowTheOneLookedAtButNotBelowTheOneRemoved() {
        BucketQueue buckets = new BucketQueue(2);
        buckets.add(1, 10, 0);
        buckets.add(2, 900_000, 0);
        assertEquals(1, buckets.removeFirst());
        assertEquals(900_000, buckets.firstKey());
        buckets.add(3, 11, 0);
        assertEquals(11, buckets.firstKey());
        assertEquals(3, buckets.removeFirst());
        String message = assertThrows(IllegalArgumentException.class, () -> buckets.add(4, 10, 0))
                .getMessage();
        assertTrue(message.contains("10") && message.contains("11"), message);
        assertEquals(2, buckets.removeFirst());
    }

    @Test
    void bucketsDropWhatIsOutdatedWhenItsBucketIsReached() {
        BitSet outdated = new BitSet();
        BucketQueue buckets = new BucketQueue(2, outdated::get);
        for (int item = 0; item < 40; item++) {
            buckets.add(item, 3L * item, 0);
        }
        outdated.set(1, 40);
        outdated.clear(30);
        assertEquals(0, buckets.removeFirst());
        assertEquals(1, buckets.removeFirst(), "its bucket had been reached before it was outdated");
        assertEquals(90, buckets.firstKey());
        assertEquals(30, buckets.removeFirst());
        assertTrue(buckets.isEmpty());
        assertEquals(0, buckets.size());
        assertThrows(IllegalStateException.class, buckets::removeFirst);
    }

    @Test
    void anEmptyListHasNoFirstEntry() {
        for (OpenList open : List.of(new MinHeap(), new BucketQueue(4))) {
            assertTrue(open.isEmpty());
            assertThrows(IllegalStateException.class, open::firstKey);
            assertThrows(IllegalStateException.class, open::removeFirst);
        }
    }
}
