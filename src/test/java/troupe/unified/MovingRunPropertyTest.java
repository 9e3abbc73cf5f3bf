package troupe.unified;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import troupe.run.Digest;
import troupe.run.Run;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Ordering;
import troupe.scene.Scene;
import troupe.unified.reference.MovingWorlds;
import troupe.unified.search.JourneyPath;

/**
 * Plans journeys through random worlds whose doorways are barred by something movable, and replays every frame
 * and every move on the polygons. {@code -Dtroupe.seed=N} starts at another seed, {@code -Dtroupe.worlds=N} makes
 * more worlds.
 */
class MovingRunPropertyTest {
    private static final long FIRST_SEED = Long.getLong("troupe.seed", 10_001);
    private static final int WORLDS = Integer.getInteger("troupe.worlds", 300);
    private static final int LAYERED = WORLDS / 8;
    private static final int SLICED = WORLDS / 6;

    private static Scene scene(long seed) {
        Journey.Manipulation manipulation = seed % 2 == 0 ? Journey.Manipulation.FREE : Journey.Manipulation.GRIP;
        Scene scene = MovingWorlds.scene(seed, manipulation);
        Journey journey = journey(scene);
        return seed % 5 == 0 ? scene.with(journey.withHeadings(24)) : scene;
    }

    /** Asks now and then for another ordering. */
    private static Scene ordered(long seed, Scene scene) {
        Journey journey = journey(scene);
        if (seed % 6 == 3) {
            return scene.with(journey.with(new Ordering.Paper(1, 1)));
        }
        return seed % 6 == 4 ? scene.with(journey.with(new Ordering.Bounded(1.5))) : scene;
    }

    private static Journey journey(Scene scene) {
        return (Journey) scene.tasks().get(0);
    }

    @Test
    void whatIsMovedMeetsNothingAndNeitherDoesWhoMovesIt() {
        Tally tally = new Tally();
        LongStream.range(FIRST_SEED, FIRST_SEED + WORLDS)
                .parallel()
                .forEach(seed -> tally.add(seed, ordered(seed, scene(seed))));
        assertTrue(tally.solved() > WORLDS / 3, tally.toString());
        assertTrue(tally.moved.get(1) > WORLDS / 10 && tally.moved.get(2) > 0, tally.toString());
    }

    @Test
    void actorsOfAllSortsMoveThingsInLayeredScenesUnharmed() {
        Tally tally = new Tally();
        LongStream.range(FIRST_SEED, FIRST_SEED + LAYERED)
                .parallel()
                .forEach(seed -> tally.add(seed, LayeredStores.scene(seed)));
        assertTrue(tally.moved.get(1) + tally.moved.get(2) > LAYERED / 5, tally.toString());
    }

    /** Plans, replays, and counts the runs by how many obstacles they move. */
    private static final class Tally {
        private final AtomicIntegerArray moved = new AtomicIntegerArray(4);

        void add(long seed, Scene scene) {
            String which = "seed " + seed;
            JourneyEngine engine = JourneyEngine.of(scene, journey(scene));
            Run run = engine.finish();
            if (run.outcome().isFound()) {
                Actor actor = scene.actors().get(0);
                JourneyPath path = engine.path().orElseThrow();
                RunCheck.assertCollisionFree(run, actor, which);
                PushCheck.assertFree(run, actor, path, which);
                double energy = run.legs().stream().mapToDouble(Run.Leg::energy).sum();
                assertEquals(path.energy(), energy, 1e-6, which);
                moved.incrementAndGet(Math.min(3, path.pushes().size()));
            }
        }

        int solved() {
            return moved.get(0) + moved.get(1) + moved.get(2) + moved.get(3);
        }

        @Override
        public String toString() {
            return "runs that move 0, 1, 2, more obstacles: " + moved;
        }
    }

    @Test
    void slicesChangeNoCostAndBudgetsNothing() {
        LongStream.range(FIRST_SEED, FIRST_SEED + SLICED).parallel().forEach(seed -> {
            Scene scene = scene(seed);
            List<Double> costs = new ArrayList<>();
            for (int slice : new int[] {1, 100, 2_000, Integer.MAX_VALUE}) {
                Journey journey = journey(scene).limited(slice, Journey.DEFAULT_EXPANSIONS);
                String which = "seed " + seed + ", slice " + slice;
                Run whole = JourneyEngine.of(scene, journey).finish();
                costs.add((double) whole.report().values().get("cost"));
                JourneyEngine bit = JourneyEngine.of(scene, journey);
                long budget = 1;
                while (bit.step(budget).isRunning()) {
                    budget = budget * 5 % 389;
                }
                assertEquals(whole.outcome(), bit.outcome(), which);
                assertEquals(Digest.of(whole.frames()), Digest.of(bit.run().frames()), which);
                assertEquals(RunCheck.untimed(whole), RunCheck.untimed(bit.run()), which);
                assertEquals(costs.get(0), costs.get(costs.size() - 1), 1e-9, which);
            }
        });
    }
}
