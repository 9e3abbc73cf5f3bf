package troupe.risk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import troupe.geometry.Polygon;
import troupe.risk.study.RandomEncounters;
import troupe.run.Digest;
import troupe.run.Engine;
import troupe.run.EngineContract;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Method;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.xml.SceneXml;
import troupe.search.Outcome;

/** Checks encounters from start to end: the contract of engines, the sample scenes, steering, certain avatars. */
class EncounterEngineTest implements EngineContract {
    private static final Avatar POINTER = Avatar.of("me", new Avatar.Pointer(Place.of(4, 5.5)));

    private static Scene scene(List<Obstacle> walls, Avatar... avatars) {
        Encounter encounter = Encounter.of("e", "ann", Place.of(1, 3), Place.of(7, 3), List.of(avatars))
                .with(Quantity.RATE, 10);
        return new Scene(
                "",
                new World(8, 6, 0.1),
                walls,
                List.of(),
                List.of(Actor.walker("ann", 0.25, 0.1)),
                List.of(encounter));
    }

    private static Obstacle wall(double x0, double y0, double x1, double y1) {
        return new Obstacle("w" + (int) (10 * y0), "", Polygon.rectangle(x0, y0, x1, y1), 0, 2, false, 20, "");
    }

    private static Avatar walking(String id, Place from, Place to, double pace) {
        return Avatar.of(id, new Avatar.Script(from, pace, List.of(new Avatar.Head(to, OptionalDouble.empty()))));
    }

    private static EncounterEngine engine(Scene scene) {
        return EncounterEngine.of(scene, (Encounter) scene.tasks().get(0));
    }

    private static Scene with(Scene scene, Encounter encounter) {
        return scene.with(encounter);
    }

    private static Encounter encounter(Scene scene) {
        return (Encounter) scene.tasks().get(0);
    }

    @Override
    public List<Engine> engines() {
        Scene open = scene(List.of(), walking("bob", Place.of(4, 1), Place.of(4, 5.5), 0.8));
        Scene shut = scene(List.of(wall(3, 0, 3.4, 6)), POINTER);
        Scene late = with(open, encounter(open).with(Quantity.DURATION, 1));
        Scene still = with(open, encounter(open).with(Method.STATIC));
        return List.of(engine(open), engine(shut), engine(late), engine(still));
    }

    private static double number(Run run, String key) {
        return ((Number) run.report().values().get(key)).doubleValue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"crossing", "plaza", "pedestrians"})
    void theSampleScenesReachTheGoalWithoutACollision(String name) throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/risk/" + name + ".xml")).scene();
        Run run = engine(scene).finish();
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(0, number(run, "collisions"));
        assertNothingIsTouched(run);
        assertTrue(number(run, "detour") < 1.5);
    }

    @Test
    void theActorBendsMoreForTheNearAndForWhatComesToward() throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/risk/influence.xml")).scene();
        List<Double> deviations = new ArrayList<>();
        for (String task : List.of("far", "near", "away", "toward")) {
            Run run = EncounterEngine.of(scene, (Encounter) scene.task(task).orElseThrow())
                    .finish();
            assertEquals(Outcome.FOUND, run.outcome());
            assertEquals(0, number(run, "collisions"));
            deviations.add(number(run, "deviation"));
        }
        assertTrue(deviations.get(0) < deviations.get(1), "far, near, away, toward: " + deviations);
        assertTrue(deviations.get(2) < deviations.get(3), "far, near, away, toward: " + deviations);
    }

    /** Measures again, on the polygons and discs themselves, that nobody and nothing was touched. */
    private static void assertNothingIsTouched(Run run) {
        Encounter encounter = (Encounter) run.scene().task(run.task()).orElseThrow();
        Actor actor = run.scene().actor(encounter.actor()).orElseThrow();
        Frames frames = run.frames();
        int x = frames.channel(actor.id(), "x");
        int y = frames.channel(actor.id(), "y");
        double radius = actor.walk().radius();
        double most = actor.walk().speed() / frames.rate() + 1e-9;
        for (int f = 0; f < frames.count(); f++) {
            double ax = frames.value(f, x, 0);
            double ay = frames.value(f, y, 0);
            for (Obstacle o : run.scene().obstacles()) {
                assertTrue(o.outline().distance(ax, ay) >= radius, "frame " + f + " in " + o.id());
            }
            for (Avatar avatar : encounter.avatars()) {
                double bx = frames.value(f, frames.channel(avatar.id(), "x"), 0);
                double by = frames.value(f, frames.channel(avatar.id(), "y"), 0);
                if (!Double.isNaN(bx)) {
                    assertTrue(
                            Math.hypot(ax - bx, ay - by) >= radius + avatar.radius(),
                            "frame " + f + " touches " + avatar.id());
                }
            }
            if (f > 0) {
                double step = Math.hypot(ax - frames.value(f - 1, x, 0), ay - frames.value(f - 1, y, 0));
                assertTrue(step <= 1.02 * most, "frame " + f + " takes " + step + " m");
            }
        }
    }

    /** In 416 three avatars close in on the actor, who once stepped into the way of one of them. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 416})
    void randomEncountersKeepToTheSpeedAndToTheOpen(long seed) {
        Run run = engine(RandomEncounters.scene(seed)).finish();
        assertEquals(Outcome.FOUND, run.outcome(), "seed " + seed);
        assertNothingIsTouched(run);
    }

    @Test
    void aSteeredAvatarMakesTheActorGiveWayAndTheRunHoldsTheInput() {
        Scene scene = scene(List.of(), POINTER);
        EncounterEngine idle = engine(scene);
        EncounterEngine steered = engine(scene);
        assertEquals(
                List.of("avatar.me.x", "avatar.me.y"),
                steered.controls().stream().map(c -> c.key()).toList());
        for (int k = 0; k < 15; k++) {
            steered.give(new Run.Input(k, "avatar.me.y", 5.5 - 0.1 * k));
            steered.step(1);
        }
        Run run = steered.finish();
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(15, run.inputs().size());
        assertTrue(number(run, "deviation") > number(idle.finish(), "deviation") + 0.1);
        EncounterEngine again = engine(scene);
        run.inputs().forEach(again::give);
        assertEquals(Digest.of(run.frames()), Digest.of(again.finish().frames()));
    }

    /** Sends it at a run onto the actor's way, a metre and more before him. */
    @Test
    void nobodyIsTouchedWhereAPersonRunsInTheWay() throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/risk/steering.xml")).scene();
        for (int tenth = 2; tenth < 40; tenth += 8) {
            for (double ahead = 1.2; ahead <= 4; ahead += 0.7) {
                double x = 1 + Actor.walker("ann", 0.25, 0.1).walk().speed() * tenth / 10 + ahead;
                EncounterEngine engine = engine(scene);
                engine.give(new Run.Input(3L * tenth, "avatar.guy.x", x));
                engine.give(new Run.Input(3L * tenth, "avatar.guy.y", 4));
                assertNothingIsTouched(engine.finish());
            }
        }
    }

    @Test
    void aSteeredAvatarFollowsAtARunAndNoFaster() {
        EncounterEngine engine = engine(scene(List.of(), POINTER));
        engine.give(new Run.Input(0, "avatar.me.x", 1));
        Run run = engine.finish();
        int x = run.frames().channel("me", "x");
        assertEquals(4 - Avatar.STEERED_PACE / 10, run.frames().value(0, x, 0), 1e-12);
        assertEquals(4 - 3 * Avatar.STEERED_PACE / 10, run.frames().value(2, x, 0), 1e-12);
        assertEquals(1, run.frames().value(12, x, 0), 1e-12);
    }

    @Test
    void refusesInputThatFitsNoControl() {
        EncounterEngine engine = engine(scene(List.of(), POINTER));
        engine.step(3);
        for (Run.Input input : List.of(
                new Run.Input(5, "avatar.you.x", 1),
                new Run.Input(5, "avatar.me.x", 8.1),
                new Run.Input(5, "avatar.me.x", Double.NaN),
                new Run.Input(2, "avatar.me.x", 1))) {
            assertThrows(IllegalArgumentException.class, () -> engine.give(input), input::toString);
        }
        assertTrue(engine.run().inputs().isEmpty());
    }

    @Test
    void aCertainAvatarIsNeverTouchedEvenWhereItsPastMisleads() {
        // it stands until the actor is near, and then walks into his way
        Avatar late = Avatar.of(
                        "late",
                        new Avatar.Script(
                                Place.of(4, 4), 1.5, List.of(new Avatar.Head(Place.of(4, 1), OptionalDouble.of(1.4)))))
                .as(Avatar.Kind.CERTAIN);
        Run run = engine(scene(List.of(), late)).finish();
        assertEquals(Outcome.FOUND, run.outcome());
        assertNothingIsTouched(run);
    }

    @Test
    void waitsOrGoesRoundWhereAnAvatarFillsTheDoor() {
        Avatar guard = walking("guard", Place.of(4, 3), Place.of(4, 3), 1);
        Scene door = scene(List.of(wall(3.8, 0, 4.2, 2.4), wall(3.8, 3.6, 4.2, 6)), guard);
        Scene brief = door.with(encounter(door).with(Quantity.DURATION, 8));
        Run run = engine(brief).finish();
        assertFalse(run.outcome().isFound());
        assertEquals(0, number(run, "collisions"));
    }

    @Test
    void planningOnceKeepsThePlan() {
        Scene scene = scene(List.of(), walking("bob", Place.of(4, 1), Place.of(4, 5.5), 0.8));
        Run run = engine(with(scene, encounter(scene).with(Method.ONCE))).finish();
        Frames frames = run.frames();
        int action = frames.channel("ann", "action");
        for (int f = 1; f < frames.count(); f++) {
            assertEquals(Action.KEPT.ordinal(), frames.value(f, action, 0));
        }
    }
}
