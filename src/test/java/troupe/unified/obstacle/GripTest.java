package troupe.unified.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.scene.Actor;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.unified.manipulation.ConfigurationSpace;
import troupe.unified.manipulation.ExpectedPath;
import troupe.unified.manipulation.Instance;
import troupe.unified.manipulation.Plans;
import troupe.unified.manipulation.Prices;
import troupe.unified.manipulation.Question;
import troupe.unified.manipulation.SlowGrip;
import troupe.unified.manipulation.Transfer;

/** Moves obstacles with an actor that holds them; results worked out by hand. */
class GripTest {
    private static final Prices PRICES = new Prices(1000, 1414, 300, 100, 141);
    private static final Actor ACTOR = Actor.walker("a", 0.2, 0);

    private static Instance instance(Scene scene, int headings, double x, double y, ExpectedPath path) {
        Movable movable = Plans.movable(scene, headings);
        Region base = new RegionBuilder(scene, ACTOR).region();
        int trigger = GridFrame.of(scene.world()).cellAt(x, y);
        Grip grip = SlowGrip.grip(scene, movable, base, trigger);
        return new Instance(new Question(
                movable,
                new Surroundings(scene),
                new ConfigurationSpace(movable, path),
                PRICES,
                Optional.of(grip),
                trigger));
    }

    private static Instance solved(Instance instance) {
        instance.advance(Long.MAX_VALUE, Long.MAX_VALUE);
        return instance;
    }

    /** A corridor from y = 1 to 2, closed at both ends, with a crate of its full width. */
    private static Scene corridor(double crateFrom, double crateTo) {
        return Plans.scene(
                8,
                3,
                0.1,
                Plans.crate(crateFrom, 1, crateTo, 2),
                Plans.wall(0, 0.5, 8, 1),
                Plans.wall(0, 2, 8, 2.5),
                Plans.wall(0, 1, 0.5, 2),
                Plans.wall(7.5, 1, 8, 2));
    }

    @Test
    void walksBehindTheCrateThatItPushes() {
        Scene scene = corridor(3, 4);
        // the path ends at 3.55; the crate must begin at 3.75 or later, eight cells on
        Instance instance = solved(instance(scene, 1, 2.75, 1.55, Plans.along(scene, 1.55, 2.75, 3.55, 0.2)));
        assertTrue(instance.outcome().isFound());
        Transfer transfer = instance.transfer();
        assertEquals(new LatticePose(8, 0, 0), transfer.last());
        assertEquals(8 * (1000 + 100), instance.cost());
        assertEquals(0.8, transfer.walked(), 1e-9);
        assertEquals(0.8, transfer.length(), 1e-9);
        assertEquals(GridFrame.of(scene.world()).cellAt(3.55, 1.55), transfer.to());
        assertTrue(transfer.gripped());
        assertEquals(1000.0 / 1100, instance.obstacleShare(), 1e-12);
    }

    @Test
    void cannotGetPastTheCrateInACorridor() {
        // it stands in the dead end to the right with a quarter of a metre on either side
        Scene scene = corridor(6, 7);
        Instance instance = solved(instance(scene, 1, 7.25, 1.55, Plans.along(scene, 1.55, 7.25, 1, 0.2)));
        assertInstanceOf(instance);
        // it can only push the crate to the other end, 5.5 m, and would be shut in behind it all the way
        assertEquals(1 + 55, instance.expanded());
    }

    private static void assertInstanceOf(Instance instance) {
        assertTrue(
                instance.outcome() instanceof Outcome.Infeasible,
                instance.outcome().word());
    }

    @Test
    void turnsWithTheObstacleAlongItsArc() {
        // an open floor; a long board across the path can be turned or shifted; turning costs next to nothing
        Scene scene = Plans.scene(10, 10, 0.1, Plans.solid(Polygon.rectangle(4, 4.9, 6, 5.1), 0, 1, true));
        Movable movable = Plans.movable(scene, 4);
        Region base = new RegionBuilder(scene, ACTOR).region();
        int trigger = GridFrame.of(scene.world()).cellAt(4.05, 5.45);
        ExpectedPath path = Plans.along(scene, 5.05, 3.05, 4.55, 0.2);
        Grip grip = SlowGrip.grip(scene, movable, base, trigger);
        Prices prices = new Prices(100000, 141400, 1, 1, 1);
        Instance instance = solved(new Instance(new Question(
                movable,
                new Surroundings(scene),
                new ConfigurationSpace(movable, path),
                prices,
                Optional.of(grip),
                trigger)));
        assertTrue(instance.outcome().isFound());
        Transfer transfer = instance.transfer();
        assertEquals(2, transfer.poses().size());
        assertEquals(Math.PI / 2, transfer.turn(), 1e-9);
        assertEquals(0, transfer.length(), 1e-9);
        // a quarter of a circle of about 1 m: between its chord and its two sides
        assertTrue(transfer.walked() > 1.4 && transfer.walked() < 2.2, "walked " + transfer.walked());
        int to = transfer.to();
        double armX = 4.05 - 5;
        double armY = 5.45 - 5;
        int k = transfer.last().k();
        double x = 5 + (k == 1 ? -armY : armY);
        double y = 5 + (k == 1 ? armX : -armX);
        assertEquals(x, base.x(to), 0.05 + 1e-9);
        assertEquals(y, base.y(to), 0.05 + 1e-9);
    }

    @Test
    void letsGoOnlyWhereItCanStand() {
        // beside the corridor's wall the body has its radius only on the middle rows
        Scene scene = corridor(3, 4);
        Instance narrow = solved(instance(scene, 24, 2.75, 1.25, Plans.along(scene, 1.55, 2.75, 3.55, 0.2)));
        assertTrue(narrow.outcome().isFound());
        Region after = new RegionBuilder(scene, ACTOR)
                .region()
                .with(0, Plans.movable(scene, 24).outline(narrow.transfer().last()));
        assertTrue(after.open(narrow.transfer().to()));
        assertFalse(after.open(GridFrame.of(scene.world()).cellAt(3.55, 1.15)));
    }

    @Test
    void stopsAtAnotherMovableObstacleHoweverLow() {
        // pulled to the left by 15 cells the crate frees the path; the plank stops the feet after 13
        Instance stopped = overPlank(true);
        assertInstanceOf(stopped);
        assertEquals(1 + 13 + 40, stopped.expanded());
        Instance pulled = overPlank(false);
        assertTrue(pulled.outcome().isFound());
        assertEquals(new LatticePose(-15, 0, 0), pulled.transfer().last());
    }

    private static Instance overPlank(boolean movable) {
        Scene scene = Plans.scene(
                8,
                3,
                0.1,
                Plans.crate(3, 1, 4, 2),
                Plans.wall(0, 0.5, 8, 1),
                Plans.wall(0, 2, 8, 2.5),
                Plans.solid(Polygon.rectangle(1, 1, 1.2, 2), 0, 0.1, movable));
        return solved(instance(scene, 1, 2.75, 1.55, Plans.along(scene, 1.55, 2.75, 7.55, 0.2)));
    }
}
