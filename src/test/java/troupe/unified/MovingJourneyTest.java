package troupe.unified;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import troupe.geometry.Polygon;
import troupe.run.Digest;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Ordering;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

/** Plans journeys in which something stands in the way and can be moved. */
class MovingJourneyTest {
    private static final Actor MOVER = mover();
    private static final Journey THROUGH = Journey.of("j", "a", Place.of(1.05, 1.55), Place.of(4.85, 1.55));

    private static Actor mover() {
        Actor walker = Actor.walker("a", 0.2, 0.05);
        return new Actor(
                walker.id(),
                walker.label(),
                walker.colour(),
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

    private static Obstacle wall(String id, double x0, double y0, double x1, double y1) {
        return new Obstacle(id, "", Polygon.rectangle(x0, y0, x1, y1), 0, 3, false, Obstacle.DEFAULT_MASS, "");
    }

    private static Obstacle crate(String id, double mass, double x0, double y0, double x1, double y1) {
        return new Obstacle(id, "", Polygon.rectangle(x0, y0, x1, y1), 0, 1.5, true, mass, "");
    }

    /** Two rooms and between them a doorway in which a crate stands. */
    private static Scene doorway(Journey journey, double mass) {
        return new Scene(
                "",
                new World(6, 3.1, 0.1),
                List.of(
                        wall("below", 3, 0, 3.2, 1),
                        wall("above", 3, 2, 3.2, 3.1),
                        crate("crate", mass, 2.72, 1.13, 3.48, 1.89)),
                List.of(),
                List.of(MOVER),
                List.of(journey));
    }

    private static Run plan(Scene scene) {
        return JourneyEngine.of(scene, (Journey) scene.tasks().get(0)).finish();
    }

    @Test
    void endsExhaustedAtTheLimitOfSearchSpaces() {
        Run one = plan(doorway(THROUGH.withSpaces(1), 20));
        assertEquals(Outcome.EXHAUSTED, one.outcome());
        assertEquals("limit.spaces", one.report().values().get("limit"));
        assertEquals(1, ((List<?>) one.report().values().get("spaces")).size());
        assertTrue(plan(doorway(THROUGH.withSpaces(5), 20)).outcome().isFound());
        Run tired = plan(doorway(THROUGH.limited(Journey.DEFAULT_SLICE, 3), 20));
        assertEquals("limit.expansions", tired.report().values().get("limit"));
    }

    private static double number(Run run, String key) {
        return (double) run.report().values().get(key);
    }

    private static List<String> moved(Run run) {
        List<String> ids = new ArrayList<>();
        for (Object each : (List<?>) run.report().values().get("moved")) {
            ids.add((String) ((Report) each).values().get("id"));
        }
        return ids;
    }

    @ParameterizedTest
    @EnumSource(Journey.Manipulation.class)
    void pushesTheCrateOutOfTheOnlyDoorway(Journey.Manipulation manipulation) {
        Run run = plan(doorway(THROUGH.with(manipulation), 10));
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(List.of("walk", "move", "walk"), run.report().values().get("abilities"));
        assertEquals(List.of("crate"), moved(run));
        RunCheck.assertKeepsRadius(run, MOVER, "doorway");
        double walked = number(run, "length");
        double energy = number(run, "energy");
        assertTrue(energy > walked + 10 * 0.3 * 0.5, energy + " J over " + walked + " m");
    }

    @Test
    void leavesTheCrateWhereMovingIsOff() {
        Journey journey = THROUGH.preferring(Preferences.NEUTRAL.with(Ability.MOVE, Preferences.OFF));
        Run run = plan(doorway(journey, 10));
        assertTrue(run.outcome() instanceof Outcome.Infeasible, run.outcome().toString());
        assertEquals(List.of("move"), run.report().values().get("would_help"));
    }

    @ParameterizedTest
    @EnumSource(Journey.Manipulation.class)
    void slicingChangesNothingThatCosts(Journey.Manipulation manipulation) {
        List<Double> costs = new ArrayList<>();
        for (int slice : new int[] {1, 100, 2_000, Integer.MAX_VALUE}) {
            Journey journey = THROUGH.with(manipulation).limited(slice, Journey.DEFAULT_EXPANSIONS);
            Run run = plan(doorway(journey, 10));
            costs.add(number(run, "cost"));
            assertEquals(
                    Digest.of(run.frames()),
                    Digest.of(plan(doorway(journey, 10)).frames()),
                    "slice " + slice);
            JourneyEngine bit = JourneyEngine.of(doorway(journey, 10), journey);
            long budget = 1;
            while (bit.step(budget).isRunning()) {
                budget = budget * 5 % 89;
            }
            assertEquals(Digest.of(run.frames()), Digest.of(bit.run().frames()), "budgets, slice " + slice);
        }
        costs.forEach(cost -> assertEquals(costs.get(0), cost, 1e-9));
    }

    @ParameterizedTest
    @ValueSource(strings = {"paper", "bounded"})
    void otherOrderingsMoveTheCrateToo(String name) {
        Ordering ordering = name.equals("paper") ? new Ordering.Paper(1, 1) : new Ordering.Bounded(1.5);
        double least = number(plan(doorway(THROUGH, 10)), "cost");
        Run run = plan(doorway(THROUGH.with(ordering), 10));
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(List.of("crate"), moved(run));
        assertTrue(number(run, "cost") >= least - 1e-9);
        assertTrue(name.equals("paper") || number(run, "cost") <= 1.5 * least + 1e-9);
    }

    @ParameterizedTest
    @EnumSource(Journey.Manipulation.class)
    void uncoversAGoalThatACrateStandsOn(Journey.Manipulation manipulation) {
        Journey journey =
                THROUGH.between(Place.of(1.05, 1.55), Place.of(3.05, 1.55)).with(manipulation);
        Run run = plan(doorway(journey, 10));
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(List.of("crate"), moved(run));
    }

    @Test
    void tellsOfSpacesAndInstances() {
        Map<String, Object> report = plan(doorway(THROUGH, 10)).report().values();
        assertTrue(((List<?>) report.get("spaces")).size() > 1);
        Map<String, Object> instances = ((Report) report.get("instances")).values();
        assertTrue((long) instances.get("established") > 0);
        assertTrue((long) instances.get("finished") > 0);
        assertTrue((long) instances.get("expanded") > 0);
        assertFalse((boolean) report.get("solved")
                && moved(plan(doorway(THROUGH, 10))).isEmpty());
    }
}
