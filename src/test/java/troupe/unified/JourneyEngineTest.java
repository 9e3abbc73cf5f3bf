package troupe.unified;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.run.Engine;
import troupe.run.EngineContract;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Ordering;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.xml.SceneXml;
import troupe.search.Outcome;

/** Plans small journeys worked out by hand: 10 m by 10 m, cells of 10 cm, from (1.05, 5.05) eight metres to the right. */
class JourneyEngineTest implements EngineContract {
    private static final Journey RIGHT = Journey.of("right", "ann", Place.of(1.05, 5.05), Place.of(9.05, 5.05));

    private static Obstacle block(String id, double height, double... box) {
        Polygon outline = Polygon.rectangle(box[0], box[1], box[2], box[3]);
        return new Obstacle(id, "", outline, 0, height, false, 20, "");
    }

    private static Scene scene(Actor actor, Journey journey, Object... parts) {
        List<Obstacle> obstacles = new ArrayList<>();
        List<Ditch> ditches = new ArrayList<>();
        for (Object part : parts) {
            if (part instanceof Ditch ditch) {
                ditches.add(ditch);
            } else {
                obstacles.add((Obstacle) part);
            }
        }
        return new Scene("", new World(10, 10, 0.1), obstacles, ditches, List.of(actor), List.of(journey));
    }

    private static Run plan(Scene scene) {
        return JourneyEngine.of(scene, (Journey) scene.tasks().get(0)).finish();
    }

    private static Run plan(Object... parts) {
        return plan(scene(Actor.standard("ann"), RIGHT, parts));
    }

    private static void assertPlan(double energy, List<String> abilities, Run run) {
        assertEquals(Outcome.FOUND, run.outcome());
        Report report = run.report();
        assertEquals(energy, (double) report.values().get("energy"), 1e-9);
        assertEquals(abilities, report.values().get("abilities"));
        assertEquals(energy, run.legs().stream().mapToDouble(Run.Leg::energy).sum(), 1e-9);
        RunCheck.assertKeepsRadius(run, run.scene().actors().get(0), "the plan");
    }

    @Override
    public List<Engine> engines() {
        Actor actor = Actor.standard("ann");
        Obstacle low = block("low", 0.8, 5, 0, 5.2, 10);
        Obstacle high = block("high", 3, 7, 0, 7.2, 10);
        Ditch canal = new Ditch("canal", "", Polygon.rectangle(3, 0, 3.5, 10), 2);
        Obstacle stub = block("stub", 3, 5, 2, 5.5, 8);
        Journey published = new Journey(
                "right",
                "",
                "ann",
                RIGHT.start(),
                RIGHT.goal(),
                Preferences.NEUTRAL,
                new Ordering.Paper(1, 1),
                Journey.Spread.BREADTH,
                Journey.Manipulation.GRIP,
                24,
                1,
                20,
                Journey.DEFAULT_SPACES,
                1);
        return List.of(
                JourneyEngine.of(scene(actor, RIGHT, stub), RIGHT),
                JourneyEngine.of(scene(actor, RIGHT, low, canal), RIGHT),
                JourneyEngine.of(scene(actor, RIGHT, low, high), RIGHT),
                JourneyEngine.of(scene(actor, RIGHT, block("box", 3, 8, 4, 10, 6)), RIGHT),
                JourneyEngine.of(scene(actor, published, stub), published));
    }

    @Test
    void walksStraightForAJouleAMetre() {
        Run run = plan();
        assertPlan(8, List.of("walk"), run);
        assertEquals(1, run.legs().size());
        assertEquals(2, run.legs().get(0).points().size());
        assertEquals(8 / 1.3, run.legs().get(0).end(), 1e-9);
        assertEquals(9.05, run.frames().value(run.frames().count() - 1, 0, 0), 1e-12);
        assertEquals(8.0, (double) run.report().values().get("smoothed_length"), 1e-9);
    }

    @Test
    void vaultsALowWall() {
        Run run = plan(block("wall", 0.8, 5.02, 0, 5.18, 10));
        assertPlan(7.3 + 0.7 * 3 + 4, List.of("walk", "vault", "walk"), run);
        Run.Leg vault = run.legs().get(1);
        assertEquals("wall", vault.what());
        assertEquals(4.75, vault.points().get(0)[0], 1e-9);
        assertEquals(5.45, vault.points().get(vault.points().size() - 1)[0], 1e-9);
        assertEquals(0.8, vault.points().stream().mapToDouble(p -> p[2]).max().orElse(0), 1e-12);
        assertEquals(1L, run.report().values().get("take_offs"));
    }

    @Test
    void stridesADitch() {
        Run run = plan(new Ditch("canal", "", Polygon.rectangle(5, 0, 5.5, 10), 2));
        assertPlan(7.2 + 0.8 * 1.5 + 1, List.of("walk", "stride", "walk"), run);
        assertEquals("", run.legs().get(1).what());
    }

    @Test
    void sidestepsThroughANarrowGap() {
        Run run = plan(block("lower", 3, 5, 0, 6, 4.86), block("upper", 3, 5, 5.24, 6, 10));
        assertPlan(6.5 + 1.5 * 2, List.of("walk", "sidestep", "walk"), run);
    }

    @Test
    void climbsStairsAndLiftsItsFeetBeforeTheirEdges() {
        Run run = plan(
                block("first", 0.2, 4, 0, 10, 10),
                block("second", 0.4, 4.6, 0, 10, 10),
                block("third", 0.6, 5.2, 0, 10, 10));
        assertPlan(8, List.of("walk"), run);
        int last = run.frames().count() - 1;
        assertEquals(0.6, run.frames().value(last, 2, 0), 1e-12);
        for (int f = 0; f <= last; f++) {
            double x = run.frames().value(f, 0, 0);
            double floor = x > 5.2 ? 0.6 : x > 4.6 ? 0.4 : x > 4 ? 0.2 : 0;
            double z = run.frames().value(f, 2, 0);
            assertTrue(z >= floor - 1e-9 && z <= floor + 0.2 + 1e-9, "z " + z + " at x " + x);
        }
    }

    @Test
    void walksRoundWhatPreferencesForbidToVault() {
        Obstacle wall = block("wall", 0.8, 5, 0, 5.2, 9);
        Journey across = RIGHT.between(Place.of(4.05, 1.05), Place.of(6.05, 1.05));
        Run over = plan(scene(Actor.standard("ann"), across, wall));
        assertEquals(List.of("walk", "vault", "walk"), over.report().values().get("abilities"));
        Journey off = new Journey(
                "right",
                "",
                "ann",
                across.start(),
                across.goal(),
                Preferences.NEUTRAL.with(Ability.VAULT, Preferences.OFF),
                Ordering.OPTIMAL,
                Journey.Spread.BREADTH,
                Journey.Manipulation.GRIP,
                24,
                1,
                1_000_000,
                Journey.DEFAULT_SPACES,
                1);
        Run round = plan(scene(Actor.standard("ann"), off, wall));
        assertEquals(List.of("walk"), round.report().values().get("abilities"));
        RunCheck.assertKeepsRadius(round, Actor.standard("ann"), "the way round");
        double length = (double) round.report().values().get("length");
        double smoothed = (double) round.report().values().get("smoothed_length");
        assertTrue(smoothed < length - 0.1, smoothed + " of " + length);
        assertTrue(smoothed > 2 * Math.hypot(1, 7.95), "no shorter than through the corner");
    }

    @Test
    void saysWhichObstacleStandsBetween() {
        Obstacle wall = new Obstacle("wall", "Inner wall", Polygon.rectangle(5, 0, 5.2, 10), 0, 3, false, 20, "");
        Run run = plan(wall, block("table", 0.7, 1, 1, 2, 2));
        Outcome.Infeasible outcome = assertInstanceOf(Outcome.Infeasible.class, run.outcome());
        assertTrue(outcome.reason().contains("'Inner wall'"), outcome.reason());
        assertEquals(List.of("wall"), run.report().values().get("blocked_by"));
        assertEquals(List.of(), run.report().values().get("blocked_together"));
        assertEquals(List.of(), run.report().values().get("would_help"));
        double area = (double) run.report().values().get("reached_area");
        assertTrue(area > 38 && area < 50, "left of the wall: " + area);
        assertEquals(0, run.frames().count());
        assertEquals(false, run.report().values().get("solved"));
    }

    @Test
    void saysWhichMovablesBarTheWayTogether() {
        Actor walker = Actor.standard("ann").without(EnumSet.of(Ability.MOVE));
        Run run = plan(scene(
                walker,
                RIGHT,
                new Obstacle("north", "", Polygon.rectangle(4, 5.5, 7, 10), 0, 3, false, 20, ""),
                new Obstacle("south", "", Polygon.rectangle(4, 0, 7, 4.5), 0, 3, false, 20, ""),
                new Obstacle("aside", "", Polygon.rectangle(1, 1, 2, 2), 0, 2, true, 20, ""),
                new Obstacle("first", "", Polygon.rectangle(4.5, 4.6, 5.2, 5.4), 0, 2, true, 20, ""),
                new Obstacle("second", "", Polygon.rectangle(6, 4.6, 6.7, 5.4), 0, 2, true, 20, "")));
        assertEquals(List.of("first", "second"), run.report().values().get("blocked_together"));
        assertEquals(List.of("north", "south"), run.report().values().get("blocked_by"));
        String reason =
                assertInstanceOf(Outcome.Infeasible.class, run.outcome()).reason();
        assertTrue(reason.contains("without 'first' and 'second', or without 'north' or 'south'"), reason);
    }

    @Test
    void saysWhichAbilityWouldHelp() {
        Actor walker = Actor.standard("ann").without(Set.of(Ability.VAULT, Ability.STRIDE, Ability.SIDESTEP));
        Run low = plan(scene(walker, RIGHT, block("wall", 0.8, 5, 0, 5.2, 10)));
        assertEquals(List.of("vault"), low.report().values().get("would_help"));
        assertEquals(List.of("wall"), low.report().values().get("blocked_by"));
        Run canal = plan(scene(walker, RIGHT, new Ditch("canal", "", Polygon.rectangle(5, 0, 5.5, 10), 2)));
        assertEquals(List.of("stride"), canal.report().values().get("would_help"));
        assertEquals(List.of("canal"), canal.report().values().get("blocked_by"));
        Run both = plan(scene(
                walker,
                RIGHT,
                block("wall", 0.8, 3, 0, 3.2, 10),
                new Ditch("canal", "", Polygon.rectangle(6, 0, 6.5, 10), 2)));
        assertEquals(
                List.of("sidestep", "stride", "vault"), both.report().values().get("would_help"));
    }

    @Test
    void saysWhenStartOrGoalIsInAnObstacle() {
        Run run = plan(block("box", 30, 9, 5, 9.1, 5.1));
        assertTrue(assertInstanceOf(Outcome.Infeasible.class, run.outcome())
                .reason()
                .contains("goal (9.05, 5.05) lies in 'box'"));
        assertEquals(List.of("box"), run.report().values().get("blocked_by"));
    }

    @Test
    void saysWhenNoFloorCarriesTheGoal() {
        Journey up = RIGHT.between(RIGHT.start(), Place.of(9.05, 5.05, 1.5));
        Run run = plan(scene(Actor.standard("ann"), up));
        String reason =
                assertInstanceOf(Outcome.Infeasible.class, run.outcome()).reason();
        assertTrue(reason.contains("goal") && reason.contains("floor"), reason);
        Run tight = plan(scene(Actor.standard("ann"), RIGHT.between(RIGHT.start(), Place.of(9.95, 5.05))));
        reason = assertInstanceOf(Outcome.Infeasible.class, tight.outcome()).reason();
        assertTrue(reason.contains("edge"), reason);
    }

    @Test
    void startIsGoal() {
        Run run = plan(scene(Actor.standard("ann"), RIGHT.between(RIGHT.start(), RIGHT.start())));
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(0.0, run.report().values().get("energy"));
        assertTrue(run.frames().count() >= 1);
        assertEquals(List.of(), run.report().values().get("abilities"));
    }

    @Test
    void refusesAJourneyOfNobody() {
        Scene scene = scene(Actor.standard("bob"), RIGHT);
        assertThrows(IllegalArgumentException.class, () -> JourneyEngine.of(scene, RIGHT));
    }

    @Test
    void namesTheCrateInTheDoorwayBeforeTheWallsAroundIt() throws Exception {
        Scene courtyard = SceneXml.read(Path.of("scenes/unified/courtyard.xml")).scene();
        Obstacle crate = courtyard.obstacle("crate").orElseThrow();
        Pose inTheDoorway = new Pose(8.1, 7.6, 0);
        Scene shut = courtyard.with(crate.withOutline(crate.outline().at(inTheDoorway)));
        Journey journey = (Journey) shut.task("to-the-fountain").orElseThrow();
        Run run = JourneyEngine.of(shut, journey.preferring(Preferences.NEUTRAL.with(Ability.MOVE, Preferences.OFF)))
                .finish();
        assertInstanceOf(Outcome.Infeasible.class, run.outcome());
        List<?> blockedBy = (List<?>) run.report().values().get("blocked_by");
        assertEquals("crate", blockedBy.get(0), blockedBy.toString());
    }

    @Test
    void saysThatAWayTakesLongerThanARunHolds() {
        Actor standard = Actor.standard("ann");
        Actor snail = new Actor(
                "ann",
                "",
                "",
                standard.bodyHeight(),
                standard.footRadius(),
                standard.stepHeight(),
                standard.maxBorder(),
                new Actor.Walk(0.25, 1, 1e-7),
                standard.sidestep(),
                standard.stride(),
                standard.vault(),
                standard.move());
        Run run = plan(scene(snail, RIGHT));
        Outcome.Infeasible outcome = assertInstanceOf(Outcome.Infeasible.class, run.outcome());
        assertTrue(outcome.reason().contains("a run holds 24 h"), outcome.reason());
        assertEquals(0, run.frames().count());
    }

    @Test
    void answersWhereTooManyFloorsLieAboveEachOther() {
        Object[] slabs = new Object[250];
        for (int i = 0; i < slabs.length; i++) {
            Polygon outline = Polygon.rectangle(4, 4, 6, 6);
            slabs[i] = new Obstacle("slab" + i, "", outline, 3 + 2 * i, 0.1, false, 20, "");
        }
        Run run = plan(slabs);
        Outcome.Infeasible outcome = assertInstanceOf(Outcome.Infeasible.class, run.outcome());
        assertTrue(outcome.reason().startsWith("251 floors above each other"), outcome.reason());
        assertTrue(outcome.reason().contains("put fewer obstacles above each other"), outcome.reason());
    }

    @Test
    void answersWhereTooManyCrossingsLieOverACell() {
        Object[] parts = new Object[161];
        for (int i = 0; i < 80; i++) {
            double x = 1 + i * 0.1;
            parts[2 * i] = block("near" + i, (i + 1) * 0.001, x, 2, x + 0.1, 3);
            parts[2 * i + 1] = block("far" + i, (i + 81) * 0.001, x, 8, x + 0.1, 9);
        }
        parts[160] = new Ditch("canal", "", Polygon.rectangle(0, 3, 10, 8), 3);
        Actor s = Actor.standard("ann");
        Actor leaper = new Actor(
                "ann",
                "",
                "",
                s.bodyHeight(),
                0,
                s.stepHeight(),
                s.maxBorder(),
                s.walk(),
                s.sidestep(),
                Optional.of(new Actor.Stride(9.9, 11, 1.5, 1, 1.5)),
                Optional.empty(),
                Optional.empty());
        Journey across = Journey.of("right", "ann", Place.of(1.05, 1.05), Place.of(9.05, 9.55));
        Outcome.Infeasible outcome = assertInstanceOf(
                Outcome.Infeasible.class, plan(scene(leaper, across, parts)).outcome());
        assertTrue(outcome.reason().contains("at most 63 fit"), outcome.reason());
    }
}
