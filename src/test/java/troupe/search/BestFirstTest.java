package troupe.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class BestFirstTest {
    private static final Outcome NO_WAY = new Outcome.Infeasible("no way");

    /** Searches the whole numbers below 1,000 from 1, each followed by its double and by itself plus three. */
    private static final class Numbers implements Expander {
        private final OpenList open;
        private final int goal;
        private final long[] best = new long[1_000];
        private final List<Integer> taken = new ArrayList<>();
        private int waitAt = -1;

        Numbers(OpenList open, int goal) {
            this.open = open;
            this.goal = goal;
            Arrays.fill(best, Long.MAX_VALUE);
            reach(1, 0);
        }

        private void reach(int number, long cost) {
            if (number < best.length && cost < best[number]) {
                best[number] = cost;
                open.add(number, cost, cost);
            }
        }

        @Override
        public Verdict expand(int item, long key) {
            if (item == waitAt) {
                open.add(item, key, key);
                return Verdict.WAITING;
            }
            if (key > best[item]) {
                return Verdict.SKIPPED;
            }
            taken.add(item);
            if (item == goal) {
                return Verdict.GOAL;
            }
            reach(2 * item, key + 5);
            reach(item + 3, key + 2);
            return Verdict.EXPANDED;
        }
    }

    @Test
    void slicedInAnyWayTakesTheSameItemsAsWhole() {
        List<List<Integer>> orders = new ArrayList<>();
        for (long budget : new long[] {1, 7, Long.MAX_VALUE}) {
            for (OpenList open : List.of(new MinHeap(), new BucketQueue(1))) {
                Numbers numbers = new Numbers(open, 997);
                BestFirst search = new BestFirst(open, numbers, NO_WAY, 10_000);
                long before = 0;
                while (search.step(budget).isRunning()) {
                    assertEquals(before + budget, search.expanded());
                    before = search.expanded();
                }
                assertSame(Outcome.FOUND, search.outcome());
                assertEquals(numbers.taken.size(), search.expanded());
                orders.add(numbers.taken);
            }
        }
        assertTrue(orders.get(0).size() > 100);
        orders.forEach(order -> assertEquals(orders.get(0), order));
    }

    @Test
    void interleavedSearchesEqualEachAlone() {
        OpenList[] open = {new MinHeap(), new MinHeap()};
        Numbers[] numbers = {new Numbers(open[0], 700), new Numbers(open[1], 411)};
        BestFirst[] searches = new BestFirst[2];
        Arrays.setAll(searches, i -> new BestFirst(open[i], numbers[i], NO_WAY, 10_000));
        while (searches[0].step(3).isRunning() | searches[1].step(2).isRunning()) {
            assertFalse(searches[0].isWaiting());
        }
        for (int i = 0; i < 2; i++) {
            OpenList alone = new MinHeap();
            Numbers whole = new Numbers(alone, numbers[i].goal);
            new BestFirst(alone, whole, NO_WAY, 10_000).step(Long.MAX_VALUE);
            assertEquals(whole.taken, numbers[i].taken);
        }
    }

    @Test
    void theLimitEndsInExhaustedAndAnEmptyListInTheGivenFailure() {
        OpenList open = new MinHeap();
        BestFirst limited = new BestFirst(open, new Numbers(open, 997), NO_WAY, 12);
        assertSame(Outcome.EXHAUSTED, limited.step(Long.MAX_VALUE));
        assertEquals(12, limited.expanded());

        OpenList other = new MinHeap();
        BestFirst hopeless = new BestFirst(other, new Numbers(other, -1), NO_WAY, 10_000);
        assertSame(NO_WAY, hopeless.step(Long.MAX_VALUE));
        hopeless.cancel();
        assertSame(NO_WAY, hopeless.outcome());
    }

    @Test
    void cancellingEndsARunningSearchForGood() {
        OpenList open = new MinHeap();
        BestFirst search = new BestFirst(open, new Numbers(open, 997), NO_WAY, 10_000);
        search.step(5);
        search.cancel();
        assertSame(Outcome.CANCELLED, search.step(5));
        assertEquals(5, search.expanded());
    }

    @Test
    void aWaitingItemPausesTheLoopUntilItIsDrivenAgain() {
        OpenList open = new MinHeap();
        Numbers numbers = new Numbers(open, 997);
        numbers.waitAt = 7;
        BestFirst search = new BestFirst(open, numbers, NO_WAY, 10_000);
        assertTrue(search.step(Long.MAX_VALUE).isRunning());
        assertTrue(search.isWaiting());
        numbers.waitAt = -1;
        assertTrue(search.step(Long.MAX_VALUE).isFound());
    }

    @Test
    void budgetsAndLimitsBelowOneAreRefused() {
        OpenList open = new MinHeap();
        Numbers numbers = new Numbers(open, 997);
        assertThrows(IllegalArgumentException.class, () -> new BestFirst(open, numbers, NO_WAY, 0));
        BestFirst search = new BestFirst(open, numbers, NO_WAY, 1);
        assertThrows(IllegalArgumentException.class, () -> search.step(0));
    }
}
