package troupe.unified.manipulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;

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

    @Test
    void ofPlacesThatCostAsLittleItIsThatOfTheLeastRow() {
        // the path runs through the middle of a crate 1 m wide; to either side it must go 0.75 m: 8 cells
        Scene scene = Plans.scene(8, 8, 0.1, Plans.crate(3.05, 3.05, 4.05, 4.05));
        Instance instance = Plans.solved(Plans.free(scene, 1, Plans.along(scene, 3.55, 1, 7, 0.25), PRICES));
        assertEquals(new LatticePose(0, -8, 0), instance.transfer().last());
        assertEquals(8 * 1000, instance.cost());
        assertTrue(instance.expanded() < 100, instance.expanded() + " expansions");
    }

    @Test
    void aBoxBehindABoxHasToBeMovedFirst() {
        // a niche 1 m wide and 2 m deep holds two boxes; only the outer one can come out
        Scene scene = Plans.scene(
                6,
                6,
                0.1,
                Plans.crate(2, 4, 3, 5),
                Plans.crate(2, 3, 3, 4),
                Plans.wall(1, 3, 2, 6),
                Plans.wall(3, 3, 4, 6),
                Plans.wall(2, 5, 3, 6));
        ExpectedPath across = Plans.along(scene, 4.55, 2.55, 2.55, 0.25);
        Instance inner = Plans.solved(Plans.free(scene, 24, across, PRICES));
        assertInstanceOf(Outcome.Infeasible.class, inner.outcome());
        assertEquals(1, inner.expanded());
        // with the outer box away the inner one comes out as far as it must: 0.8 m, its rear at 4.2 m
        Movable movable = Plans.movable(scene, 24);
        Surroundings after = new Surroundings(scene).with(1, Polygon.rectangle(4.5, 1, 5.5, 2));
        Instance freed = Plans.solved(new Question(
                movable, after, new ConfigurationSpace(movable, across), PRICES, Optional.empty(), across.cell(0)));
        assertTrue(freed.outcome().isFound());
        assertEquals(new LatticePose(0, -7, 0), freed.transfer().last());
    }

    @Test
    void aBookSlidesAlongTheShelfButNotOffIt() {
        Obstacle shelf = Plans.solid(Polygon.rectangle(1, 1, 3, 1.3), 1, 0.05, false);
        Obstacle book = Plans.solid(Polygon.rectangle(1.2, 1, 1.4, 1.3), 1.05, 0.3, true);
        Scene scene = Plans.scene(4, 4, 0.1, book, shelf);
        Instance instance = Plans.solved(Plans.free(scene, 4, Plans.along(scene, 1.15, 0.05, 1.65, 0.2), PRICES));
        assertTrue(instance.outcome().isFound());
        for (LatticePose pose : instance.transfer().poses()) {
            assertTrue(new Surroundings(scene).support(Plans.movable(scene, 4)).rests(pose.i(), pose.j(), pose.k()));
        }
        // the path ends at 1.65: the book must begin at 1.85, seven cells on
        assertEquals(new LatticePose(7, 0, 0), instance.transfer().last());
    }

    @Test
    void stopsBeforeCostsOverflow() {
        Scene scene = Plans.scene(8, 8, 0.1, Plans.crate(3, 3, 4, 4));
        long dear = Prices.BLOCKED / 3;
        ExpectedPath path = Plans.along(scene, 3.55, 1, 7, 0.25);
        Instance instance = Plans.solved(Plans.free(scene, 8, path, new Prices(dear, dear, dear, 0, 0)));
        assertInstanceOf(Outcome.Infeasible.class, instance.outcome());
        assertTrue(instance.expanded() > 10 && instance.expanded() < 1000, instance.expanded() + " expansions");
    }
}
