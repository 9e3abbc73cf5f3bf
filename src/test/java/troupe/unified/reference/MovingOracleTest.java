package troupe.unified.reference;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.function.LongConsumer;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Ordering;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;
import troupe.unified.JourneyEngine;

/**
 * Compares the planner with {@link ExhaustivePlanner} on small random worlds whose doorways are mostly barred by
 * something movable. A failure names the seed and holds the scene; {@code -Dtroupe.seed=N} starts at another one.
 */
class MovingOracleTest {
    private static final long FIRST_SEED = Long.getLong("troupe.seed", 1);
    private static final int SCENES = Integer.getInteger("troupe.scenes", 320);
    private static final double TOLERANCE = 1e-6;

    @Test
    void wayAndCostAreTheSameWhereNothingCanBeMoved() {
        AtomicIntegerArray solved = new AtomicIntegerArray(2);
        each(250, seed -> {
            Scene scene = fixed(MovingWorlds.scene(seed, Journey.Manipulation.FREE));
            Answer answer = compare(seed, scene);
            solved.incrementAndGet(answer.isSolved() ? 1 : 0);
        });
        assertTrue(solved.get(0) > 25 && solved.get(1) > 25, "unsolved and solved: " + solved);
    }

    @Test
    void leastCostIsFoundWhateverHasToBeMoved() {
        AtomicIntegerArray moved = new AtomicIntegerArray(4);
        AtomicInteger unsolved = new AtomicInteger();
        AtomicInteger turned = new AtomicInteger();
        each(SCENES, seed -> {
            Answer answer = compare(seed, MovingWorlds.scene(seed, manipulation(seed)));
            moved.incrementAndGet(Math.min(3, answer.moved().size()));
            unsolved.addAndGet(answer.isSolved() ? 0 : 1);
            turned.addAndGet(answer.moved().stream().anyMatch(m -> m.pose().k() != 0) ? 1 : 0);
        });
        String found = unsolved + " unsolved; moved none, one, two, more: " + moved + "; turned in " + turned;
        assertTrue(turned.get() > SCENES / 20, found);
        assertTrue(moved.get(1) > SCENES / 5 && moved.get(2) > SCENES / 20 && unsolved.get() > SCENES / 20, found);
    }

    @Test
    void theBoundedOrderingStaysWithinItsWeight() {
        each(120, seed -> {
            Scene scene = MovingWorlds.scene(seed, manipulation(seed));
            Journey journey = (Journey) scene.tasks().get(0);
            double least = ExhaustivePlanner.solve(scene, journey).cost();
            double weight = seed % 3 == 0 ? 4 : 1.3;
            double cost = cost(scene, journey.with(new Ordering.Bounded(weight)));
            boolean within = cost >= least * (1 - TOLERANCE) && cost <= weight * least * (1 + TOLERANCE);
            if (!within && cost != least) {
                throw new AssertionError("seed " + seed + ": the planner's cost is " + cost + " with weight " + weight
                        + ", the least is " + least + "\n" + SceneXml.write(scene));
            }
        });
    }

    @Test
    void movableObstaclesAreInTheWayWhereMovingIsSwitchedOff() {
        each(100, seed -> {
            Scene scene = MovingWorlds.scene(seed, Journey.Manipulation.FREE);
            Journey journey = (Journey) scene.tasks().get(0);
            compare(seed, scene.with(journey.preferring(journey.preferences().with(Ability.MOVE, Preferences.OFF))));
        });
    }

    @Test
    void theBoundOnTheCostToGoIsNoneTooHighInAnySpace() {
        AtomicInteger checked = new AtomicInteger();
        each(80, seed -> {
            Journey.Manipulation manipulation = manipulation(seed);
            Scene scene = MovingWorlds.scene(seed, manipulation);
            ExhaustivePlanner planner =
                    new ExhaustivePlanner(scene, (Journey) scene.tasks().get(0));
            planner.solve();
            checked.addAndGet(planner.checkBounds(7));
        });
        assertTrue(checked.get() > 1000, "checked " + checked);
    }

    private static Journey.Manipulation manipulation(long seed) {
        return seed % 2 == 0 ? Journey.Manipulation.FREE : Journey.Manipulation.GRIP;
    }

    /** Leaves out two of three movable obstacles and fastens the others. */
    private static Scene fixed(Scene scene) {
        List<Obstacle> left = new ArrayList<>();
        for (int n = 0; n < scene.obstacles().size(); n++) {
            Obstacle o = scene.obstacles().get(n);
            if (!o.movable() || n % 3 == 0) {
                left.add(new Obstacle(o.id(), "", o.outline(), o.offset(), o.height(), false, o.mass(), ""));
            }
        }
        return new Scene(scene.title(), scene.world(), left, scene.ditches(), scene.actors(), scene.tasks());
    }

    /** Returns the cost of the planner's way, infinite if it finds none. */
    static double cost(Scene scene, Journey journey) {
        Map<String, Object> report =
                JourneyEngine.of(scene, journey).finish().report().values();
        return (boolean) report.get("solved") ? (double) report.get("cost") : Double.POSITIVE_INFINITY;
    }

    private static Answer compare(long seed, Scene scene) {
        Journey journey = (Journey) scene.tasks().get(0);
        Answer answer = ExhaustivePlanner.solve(scene, journey);
        double cost = cost(scene, journey);
        boolean same = cost == answer.cost() || Math.abs(cost - answer.cost()) <= TOLERANCE * answer.cost();
        if (!same) {
            throw new AssertionError("seed " + seed + ": the planner's cost is " + cost + ", the least is " + answer
                    + "\n" + SceneXml.write(scene));
        }
        return answer;
    }

    /** Compares many seeds and fails with all those that differ, the first of them in full. */
    private static void each(int seeds, LongConsumer comparison) {
        ConcurrentSkipListMap<Long, AssertionError> wrong = new ConcurrentSkipListMap<>();
        LongStream.range(FIRST_SEED, FIRST_SEED + seeds).parallel().forEach(seed -> {
            try {
                comparison.accept(seed);
            } catch (AssertionError difference) {
                wrong.put(seed, difference);
            }
        });
        if (!wrong.isEmpty()) {
            throw new AssertionError(
                    "seeds " + wrong.keySet() + " differ", wrong.firstEntry().getValue());
        }
    }
}
