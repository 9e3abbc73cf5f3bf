package troupe.unified.manipulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import troupe.scene.Scene;
import troupe.search.Outcome;

/** Puts obstacles out of the way of straight paths; results worked out by hand. */
class InstanceTest {
    private static final Prices PRICES = new Prices(1000, 1414, 300, 100, 141);

    @Test
    void pushesACrateAlongACorridorUntilThePathIsFree() {
        // a corridor 1 m wide with a bay; the crate fills the width, the path crosses the corridor at x = 2
        Scene scene =
                Plans.scene(8, 3, 0.1, Plans.crate(1.5, 1, 2.5, 2), Plans.wall(0, 0.5, 8, 1), Plans.wall(0, 2, 8, 2.5));
        ExpectedPath path = Plans.along(scene, 1.55, 1.05, 2.05, 0.25);
        Instance instance = Plans.solved(Plans.free(scene, 1, path, PRICES));
        assertTrue(instance.outcome().isFound());
        // the last centre is at 2.05; the crate must begin at 2.05 + 0.25 or later: 0.8 m to the right
        assertEquals(new LatticePose(8, 0, 0), instance.transfer().last());
        assertEquals(8 * 1000, instance.cost());
        assertEquals(0.8, instance.transfer().length(), 1e-9);
        assertEquals(8 * 1000, instance.least());
    }

    @Test
    void saysThatACrateBetweenWallsCannotBeMoved() {
        Scene scene = Plans.scene(
                8,
                3,
                0.1,
                Plans.crate(1.5, 1, 2.5, 2),
                Plans.wall(0, 0.5, 8, 1),
                Plans.wall(0, 2, 8, 2.5),
                Plans.wall(2.5, 1, 3, 2),
                Plans.wall(1, 1, 1.5, 2));
        Instance instance = Plans.solved(Plans.free(scene, 24, Plans.along(scene, 1.55, 1.05, 7, 0.25), PRICES));
        assertInstanceOf(Outcome.Infeasible.class, instance.outcome());
        assertEquals(1, instance.expanded());
        assertEquals(Long.MAX_VALUE, instance.least());
    }

    @Test
    void stopsWhereNothingOpenCostsLittleEnough() {
        Scene scene = Plans.scene(8, 8, 0.1, Plans.crate(3, 3, 4, 4));
        Instance instance = new Instance(Plans.free(scene, 24, Plans.along(scene, 3.55, 1, 7, 0.25), PRICES));
        instance.advance(Long.MAX_VALUE, 2500);
        assertTrue(instance.outcome().isRunning());
        assertTrue(instance.least() > 2500);
        assertEquals(0, instance.advance(10, 2500));
        instance.advance(Long.MAX_VALUE, Long.MAX_VALUE);
        assertTrue(instance.outcome().isFound());
        assertFalse(instance.question()
                .barred()
                .contains(
                        instance.transfer().last().i(),
                        instance.transfer().last().j(),
                        instance.transfer().last().k()));
    }
}
