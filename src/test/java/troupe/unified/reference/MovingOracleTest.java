package troupe.unified.reference;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.SceneXml;
import troupe.unified.JourneyEngine;

/**
 * Compares the planner with {@link ExhaustivePlanner} on small random worlds whose doorways are mostly barred by
 * something movable. A failure names the seed and holds the scene; {@code -Dtroupe.seed=N} starts at another one.
 */
class MovingOracleTest {
    private static final long FIRST_SEED = Long.getLong("troupe.seed", 1);
    private static final double TOLERANCE = 1e-6;

    @Test
    void wayAndCostAreTheSameWhereNothingCanBeMoved() {
        AtomicIntegerArray solved = new AtomicIntegerArray(2);
        LongStream.range(FIRST_SEED, FIRST_SEED + 400).parallel().forEach(seed -> {
            Scene scene = fixed(MovingWorlds.scene(seed, Journey.Manipulation.FREE));
            Answer answer = compare(seed, scene);
            solved.incrementAndGet(answer.isSolved() ? 1 : 0);
        });
        assertTrue(solved.get(0) > 40 && solved.get(1) > 40, "unsolved and solved: " + solved);
    }

    @Test
    void movableObstaclesAreInTheWayWhereMovingIsSwitchedOff() {
        LongStream.range(FIRST_SEED, FIRST_SEED + 200).parallel().forEach(seed -> {
            Scene scene = MovingWorlds.scene(seed, Journey.Manipulation.FREE);
            Journey journey = (Journey) scene.tasks().get(0);
            compare(seed, scene.with(journey.preferring(journey.preferences().with(Ability.MOVE, Preferences.OFF))));
        });
    }

    @Test
    void theBoundOnTheCostToGoIsNoneTooHighInAnySpace() {
        AtomicInteger checked = new AtomicInteger();
        LongStream.range(FIRST_SEED, FIRST_SEED + 150).parallel().forEach(seed -> {
            Journey.Manipulation manipulation = manipulation(seed);
            Scene scene = MovingWorlds.scene(seed, manipulation);
            ExhaustivePlanner planner =
                    new ExhaustivePlanner(scene, (Journey) scene.tasks().get(0));
            planner.solve();
            checked.addAndGet(planner.checkBounds(7));
        });
        assertTrue(checked.get() > 2000, "checked " + checked);
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

    private static Answer compare(long seed, Scene scene) {
        Journey journey = (Journey) scene.tasks().get(0);
        Answer answer = ExhaustivePlanner.solve(scene, journey);
        Run run = JourneyEngine.of(scene, journey).finish();
        Map<String, Object> report = run.report().values();
        double cost = (boolean) report.get("solved") ? (double) report.get("cost") : Double.POSITIVE_INFINITY;
        boolean same = cost == answer.cost() || Math.abs(cost - answer.cost()) <= TOLERANCE * answer.cost();
        if (!same) {
            fail("seed " + seed + ": the planner's cost is " + cost + ", moved " + report.get("moved")
                    + ", the least is " + answer + "\n" + SceneXml.write(scene));
        }
        return answer;
    }
}
