package troupe.unified.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Works the reference out by hand: corridors a metre wide, cells of 25 cm, an actor of 20 cm radius to whom a
 * metre of walking costs 1 J and a metre of moving 0.3 J for each kilogram.
 */
class ReferenceTest {
    private static final double TOLERANCE = 1e-9;

    private final List<Obstacle> obstacles = new ArrayList<>();

    private void wall(double minX, double minY, double maxX, double maxY) {
        fixed(Polygon.rectangle(minX, minY, maxX, maxY), 2.5);
    }

    private void fixed(Polygon outline, double height) {
        obstacles.add(new Obstacle("wall" + obstacles.size(), "", outline, 0, height, false, 20, ""));
    }

    private void crate(String id, double mass, double offset, double minX, double minY, double maxX, double maxY) {
        Polygon outline = Polygon.rectangle(minX, minY, maxX, maxY);
        obstacles.add(new Obstacle(id, "", outline, offset, 1.5, true, mass, ""));
    }

    private static Actor actor() {
        Actor walker = Actor.walker("a", 0.2, 0.1);
        return new Actor(
                walker.id(),
                "",
                "",
                walker.bodyHeight(),
                walker.footRadius(),
                walker.stepHeight(),
                walker.maxBorder(),
                walker.walk(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.of(Actor.Move.DEFAULT));
    }

    private Answer solve(double width, double depth, Journey journey) {
        Scene scene =
                new Scene("", new World(width, depth, 0.25), obstacles, List.of(), List.of(actor()), List.of(journey));
        Answer answer = ExhaustivePlanner.solve(scene, journey);
        assertEquals(answer.cost(), MovingOracleTest.cost(scene, journey), TOLERANCE, "the planner");
        return answer;
    }

    private static Journey free(double fromX, double toX) {
        return Journey.of("j", "a", Place.of(fromX, 0.375), Place.of(toX, 0.375))
                .with(Journey.Manipulation.FREE)
                .withHeadings(4);
    }

    private static Journey grip(double fromX, double toX) {
        return free(fromX, toX).with(Journey.Manipulation.GRIP);
    }

    @Test
    void aCrateThatFillsACorridorIsPutBehindTheTriggerOrPushedPastTheGoal() {
        crate("crate", 20, 0, 1.5, 0, 2, 1);
        Answer behind = solve(4, 1, free(0.625, 2.625));
        assertEquals(2 + 1.25 * 20 * 0.3, behind.cost(), TOLERANCE);
        assertEquals(List.of(new Answer.Moved("crate", new Mover.Pose(-5, 0, 0))), behind.moved());
        Answer pushed = solve(4, 1, grip(0.625, 2.625));
        assertEquals(0.5 + 1.5 * (20 * 0.3 + 1), pushed.cost(), TOLERANCE);
        assertEquals(List.of(new Answer.Moved("crate", new Mover.Pose(6, 0, 0))), pushed.moved());
    }

    @Test
    void aCorridorThatEndsTooSoonBehindTheGoalKeepsTheCrateIn() {
        crate("crate", 20, 0, 1.5, 0, 2, 1);
        assertFalse(solve(3.25, 1, grip(0.625, 2.625)).isSolved());
        assertTrue(solve(3.5, 1, grip(0.625, 2.625)).isSolved());
    }

    @Test
    void nothingIsMovedWhereMovingIsSwitchedOff() {
        crate("crate", 20, 0, 1.5, 0, 2, 1);
        Journey journey = free(0.625, 2.625);
        Preferences off = Preferences.NEUTRAL.with(Ability.MOVE, Preferences.OFF);
        assertFalse(solve(4, 1, journey.preferring(off)).isSolved());
        Preferences dear = Preferences.NEUTRAL.with(Ability.MOVE, 3);
        assertEquals(
                2 + 3 * 1.25 * 20 * 0.3, solve(4, 1, journey.preferring(dear)).cost(), TOLERANCE);
    }

    @Test
    void theDearerOfTwoWaysIsLeft() {
        wall(2, -1, 2.2, 0.1);
        wall(2, 0.9, 2.2, 1.1);
        wall(2, 1.9, 2.2, 3);
        crate("crate", 20, 0, 2, 0.2, 2.4, 0.8);
        double heavy = solve(4, 2, free(0.625, 3.375)).cost();
        double light = lighter().cost();
        obstacles.set(3, new Obstacle("crate", "", obstacles.get(3).outline(), 0, 1.5, false, 20, ""));
        double around = solve(4, 2, free(0.625, 3.375)).cost();
        assertEquals(around, heavy, TOLERANCE);
        assertEquals(2.75, light, 0.01);
        assertTrue(around > 3);
    }

    private Answer lighter() {
        Obstacle crate = obstacles.get(3);
        obstacles.set(3, new Obstacle("crate", "", crate.outline(), 0, 1.5, true, 0.001, ""));
        return solve(4, 2, free(0.625, 3.375));
    }

    @Test
    void twoCratesOneAfterTheOtherAreBothMoved() {
        crate("first", 10, 0, 2, 0, 2.5, 1);
        crate("second", 12, 0, 3.5, 0, 4, 1);
        Answer answer = solve(6, 1, free(1.625, 4.625));
        assertEquals(3 + 1.25 * 10 * 0.3 + 1.25 * 12 * 0.3, answer.cost(), TOLERANCE);
        assertEquals(2, answer.moved().size());
        assertFalse(solve(6, 1, grip(1.625, 4.625)).isSolved());
    }

    @Test
    void aCrateFlushInItsDoorwaySlidesAndOneThatIsStuckDoesNot() {
        wall(1.5, -1, 1.9, 0.1);
        wall(1.5, 0.7, 1.9, 2);
        crate("crate", 5, 0, 1.5, 0.1, 1.9, 0.7);
        Answer slid = solve(4, 1, grip(0.625, 2.625));
        assertTrue(slid.isSolved());
        assertEquals(1, slid.moved().size());
        obstacles.remove(2);
        crate("crate", 5, 0, 1.5, 0.1 - 1e-6, 1.9, 0.7);
        assertFalse(solve(4, 1, grip(0.625, 2.625)).isSolved());
    }

    @Test
    void aBoxIsNotPushedOffItsShelf() {
        fixed(Polygon.rectangle(0.75, -0.1, 2.75, 1.1), 0.2);
        crate("box", 5, 0.2, 1.5, 0, 2, 1);
        assertFalse(solve(4, 1, free(0.625, 2.875)).isSolved());
        assertFalse(solve(4, 1, grip(0.625, 2.875)).isSolved());
        obstacles.set(0, new Obstacle("shelf", "", Polygon.rectangle(0.75, -0.1, 4, 1.1), 0, 0.2, false, 1, ""));
        Answer along = solve(4, 1, grip(0.625, 2.625));
        assertEquals(0.5 + 1.5 * (5 * 0.3 + 1), along.cost(), TOLERANCE);
    }

    @Test
    void whatCarriesSomethingStays() {
        crate("crate", 20, 0, 1.5, 0, 2, 1);
        obstacles.add(new Obstacle("jug", "", Polygon.rectangle(1.6, 0.4, 1.8, 0.6), 1.5, 0.2, true, 1, ""));
        assertFalse(solve(4, 1, free(0.625, 2.625)).isSolved());
        obstacles.remove(1);
        obstacles.add(new Obstacle("lamp", "", Polygon.rectangle(1.6, 0.4, 1.8, 0.6), 1.8, 0.2, true, 1, ""));
        assertTrue(solve(4, 1, free(0.625, 2.625)).isSolved());
    }

    @Test
    void aTurnHasToHaveRoomAllTheWay() {
        Ground ground = new Ground(
                new Scene(
                        "",
                        new World(4, 4, 0.25),
                        List.of(
                                new Obstacle("m", "", Polygon.rectangle(1.5, 1.8, 2.5, 2.2), 0, 1, true, 1, ""),
                                new Obstacle("p", "", Polygon.rectangle(2.35, 2.3, 2.4, 2.35), 0, 1, false, 1, "")),
                        List.of(),
                        List.of(),
                        List.of()),
                actor());
        Polygon[] outlines = {ground.scene.obstacles().get(0).outline(), null};
        Mover mover = new Mover(ground, 0, outlines, 4);
        Mover.Pose home = new Mover.Pose(0, 0, 0);
        assertTrue(mover.isSupported(home));
        assertFalse(mover.allows(home, 8), "the post stands within the circle of the corners");
        assertTrue(mover.allows(home, 2));
        assertTrue(mover.allows(new Mover.Pose(-2, 0, 0), 8));
        assertTrue(mover.allows(home, 0), "it slides below the post");
        assertFalse(mover.allows(home, 1), "the post is in the way north");
    }
}
