package troupe.risk.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.grid.region.Region;
import troupe.risk.forecast.Forecast;
import troupe.risk.forecast.History;
import troupe.risk.forecast.Ways;
import troupe.risk.study.RandomEncounters;
import troupe.scene.Actor;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Scene;

/** Asserts that what an encounter does at every step takes no memory once it has done it before. */
class KernelAllocationTest {
    private static final int STEPS = 60;
    /** Bytes: what the counting itself takes, and the loop of a search and its outcome, however long it is. */
    private static final long SMALL = 4_096;
    /** An encounter of ten avatars. */
    private static final long SEED = 419;

    private final Scene scene = RandomEncounters.scene(SEED);

    private final Encounter encounter = (Encounter) scene.tasks().get(0);
    private final Ground ground = new Ground(scene, scene.actors().get(0), encounter.goal());
    private final Forecast forecast = new Forecast(encounter, new Ways(Region.of(scene, Actor.walker("avatar", 0, 0))));
    private final List<History> pasts = new ArrayList<>();
    private final Hazards hazards = new Hazards(near(), encounter.number(Quantity.HORIZON));
    private final PathRisk risk = new PathRisk(forecast, hazards);
    private final TimeSearch search = new TimeSearch(ground, encounter, forecast, hazards, 60_000);
    private final Updating updating = new Updating(ground, risk, 12, 2, encounter.number(Quantity.HORIZON));
    private final TimedPath plan = new TimedPath();
    private final TimedPath fresh = new TimedPath();
    /** The places of the avatars step by step, worked out before: newer Java's sine and cosine take memory. */
    private final double[][] places = new double[3 * STEPS][];

    private long expanded;
    private double sum;

    private double[] near() {
        double[] near = new double[encounter.avatars().size()];
        Arrays.fill(near, 0.55);
        return near;
    }

    @Test
    void lookingForecastingAndUpdatingTakeNoMemory() throws ReflectiveOperationException {
        assertEquals(RandomEncounters.MOST, encounter.avatars().size());
        begin();
        look(0);
        search();
        plan.set(fresh);
        double first = steps(1);
        long before = allocated();
        double second = steps(STEPS + 1);
        long taken = allocated() - before;
        assertTrue(first > 0 && second > 0, first + " and " + second);
        assertTrue(taken < SMALL, "took " + taken + " bytes for " + STEPS + " steps");
    }

    @Test
    void aSecondSearchTakesAlmostNoMemory() throws ReflectiveOperationException {
        begin();
        for (int k = 0; k < 10; k++) {
            look(k);
        }
        search();
        long once = expanded;
        long before = allocated();
        search();
        long taken = allocated() - before;
        assertTrue(once > 100 && expanded == once, once + " and " + expanded + " expanded");
        assertTrue(taken < SMALL, "took " + taken + " bytes for " + expanded + " expansions");
    }

    private void begin() {
        for (int a = 0; a < encounter.avatars().size(); a++) {
            pasts.add(new History(Forecast.capacity(encounter)));
        }
        for (int step = 0; step < places.length; step++) {
            places[step] = placesAt(step);
        }
    }

    /** Puts each avatar on a path of its own. */
    private double[] placesAt(int step) {
        double[] all = new double[2 * pasts.size()];
        for (int a = 0; a < pasts.size(); a++) {
            double turn = 0.3 * a + 0.4 * step / encounter.number(Quantity.RATE);
            all[2 * a] = 6 + 3 * StrictMath.cos(turn);
            all[2 * a + 1] = 5 + 3 * StrictMath.sin(turn);
        }
        return all;
    }

    /** Sees every avatar a thirtieth of a second on. */
    private void look(int step) {
        for (int a = 0; a < pasts.size(); a++) {
            pasts.get(a).see(step / encounter.number(Quantity.RATE), places[step][2 * a], places[step][2 * a + 1]);
        }
        forecast.compute(pasts);
        hazards.clear();
        for (int a = 0; a < pasts.size(); a++) {
            for (int k = 0; k < 3; k++) {
                double ahead = k * Hazards.STAMP;
                hazards.stamp(a, k, forecast.expectedX(a, ahead), forecast.expectedY(a, ahead));
            }
        }
    }

    private double steps(int from) {
        sum = 0;
        for (int k = from; k < from + STEPS; k++) {
            look(k);
            updating.update(plan, k / encounter.number(Quantity.RATE));
            sum += risk.mean(plan, k / encounter.number(Quantity.RATE));
            sum += risk.hits(plan, 0, 0, 1) ? 1 : 0;
        }
        return sum;
    }

    private void search() {
        int q = ground.region().locate(encounter.start());
        assertTrue(search.search(encounter.start().x(), encounter.start().y(), q, 0, fresh)
                .isFound());
        expanded = search.expanded();
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
