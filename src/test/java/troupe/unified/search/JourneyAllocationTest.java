package troupe.unified.search;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import troupe.grid.region.RandomScenes;
import troupe.grid.region.Region;
import troupe.scene.Actor;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.JourneyQuery;

/** Asserts that a search on a workspace that has been used before takes no memory for its expansions. */
class JourneyAllocationTest {
    private static final long SMALL = 32_768;

    @Test
    void aSecondSearchOfThousandsOfExpansionsTakesAlmostNoMemory() throws ReflectiveOperationException {
        Region region = Region.of(RandomScenes.flat(5, 60, 0.2, 30), Actor.walker("a", 0.25, 0.1));
        JourneyWorkspace work = new JourneyWorkspace(region);
        JourneyCosts costs = new JourneyCosts(region.actor(), Preferences.NEUTRAL, 0.2);
        JourneyQuery query = JourneyQuery.optimal(openPlace(region, 1), openPlace(region, 59));
        long expanded = run(work, costs, query);
        assertTrue(expanded > 2_000, "expanded " + expanded);
        long before = allocated();
        run(work, costs, query);
        long taken = allocated() - before;
        assertTrue(taken < SMALL, "took " + taken + " bytes for " + expanded + " expansions");
    }

    private static long run(JourneyWorkspace work, JourneyCosts costs, JourneyQuery query) {
        JourneySearch search = new JourneySearch(work, costs, query);
        assertTrue(search.step(Long.MAX_VALUE).isFound());
        return search.expanded() + search.estimated();
    }

    private static int openPlace(Region region, double at) {
        for (double y = at; ; y += at < 30 ? 0.2 : -0.2) {
            int q = region.locate(Place.of(at, y));
            if (region.open(q) && region.elevation(q) == 0) {
                return q;
            }
        }
    }

    /** Returns the bytes that this thread has taken so far; by name, as the modules of the tests do not read it. */
    private static long allocated() throws ReflectiveOperationException {
        Object threads = Class.forName("java.lang.management.ManagementFactory")
                .getMethod("getThreadMXBean")
                .invoke(null);
        return (long) Class.forName("com.sun.management.ThreadMXBean")
                .getMethod("getThreadAllocatedBytes", long.class)
                .invoke(threads, Thread.currentThread().getId());
    }
}
