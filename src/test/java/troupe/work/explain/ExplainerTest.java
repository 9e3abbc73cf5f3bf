package troupe.work.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import troupe.geometry.Polygon;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Ordering;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.World;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;

/** Explains a room that can be worked out by hand, and every sample journey. */
class ExplainerTest {
    /** 4 m straight on, 0.7 m of them vaulted: between the standing places 0.25 m beside the wall. */
    private static final double VAULT = 3 * 0.7 + 4;

    private static final double WALK = 3.3;

    /** From 1.05 to 2.65 by diagonal steps and 2.6 m straight up, 0.7 m past the wall, from 3.35 to 5.05. */
    private static final double ROUND = (1.6 + 1.7) * Math.sqrt(2) + 2.6 + 0.7 + 2.5;

    private static Scene room(double wallEnd) {
        Actor ann = Actor.standard("ann").without(Set.of(Ability.SIDESTEP, Ability.STRIDE, Ability.MOVE));
        Obstacle wall = new Obstacle("wall", "", Polygon.rectangle(2.92, 0, 3.08, wallEnd), 0, 0.8, false, 20, "");
        Journey across = Journey.of("across", "ann", Place.of(1.05, 1.05), Place.of(5.05, 1.05));
        return new Scene("", new World(6, 6, 0.1), List.of(wall), List.of(), List.of(ann), List.of(across));
    }

    private static Scene preferring(Scene scene, String task, Ability ability, double preference) {
        Journey journey = (Journey) scene.task(task).orElseThrow();
        return scene.with(journey.preferring(journey.preferences().with(ability, preference)));
    }

    private static Run plan(Scene scene, String task) {
        return Tasks.start(scene, task).finish();
    }

    private static Explanation explain(Scene scene, String task) {
        return new Explainer(ExplainerTest::plan).explain(plan(scene, task));
    }

    @Test
    void tellsWhatALowWallIsWorth() {
        Explanation explanation = explain(room(4.98), "across");
        Route plan = explanation.plan();
        assertEquals(List.of("walk", "vault wall", "walk"), plan.course());
        assertEquals(WALK, plan.energy(Ability.WALK), 1e-9);
        assertEquals(VAULT, plan.energy(Ability.VAULT), 1e-9);
        assertEquals(
                List.of(Set.of(Ability.VAULT), Set.of(Ability.SIDESTEP, Ability.STRIDE, Ability.VAULT, Ability.MOVE)),
                explanation.without().stream().map(Route::without).toList());
        for (Route round : explanation.without()) {
            assertEquals(List.of("walk"), round.course());
            assertEquals(ROUND, round.cost(Preferences.NEUTRAL), 1e-9);
            assertEquals(ROUND, round.length(), 1e-9);
        }
    }

    @Test
    void findsThePreferenceWhereTheWayRoundCostsTheSame() {
        Scene scene = room(4.98);
        Explanation explanation = explain(scene, "across");
        assertEquals(1, explanation.flips().size(), explanation.flips().toString());
        Flip flip = explanation.givenUp(Ability.VAULT).orElseThrow();
        assertEquals((ROUND - WALK) / VAULT, flip.preference(), 1e-9);
        assertEquals(flip.preference(), flip.times());
        Run below = plan(preferring(scene, "across", Ability.VAULT, 0.99 * flip.preference()), "across");
        Run above = plan(preferring(scene, "across", Ability.VAULT, 1.01 * flip.preference()), "across");
        assertEquals(List.of("walk", "vault wall", "walk"), new Route(Set.of(), below).course());
        assertEquals(List.of("walk"), new Route(Set.of(), above).course());
    }

    @Test
    void countsTimesFromThePreferenceOfTheTask() {
        Flip flip = explain(preferring(room(4.98), "across", Ability.VAULT, 0.5), "across")
                .givenUp(Ability.VAULT)
                .orElseThrow();
        assertEquals((ROUND - WALK) / VAULT, flip.preference(), 1e-9);
        assertEquals(2 * flip.preference(), flip.times(), 1e-9);
    }

    @Test
    void saysWhyNothingReplacesAnAbility() {
        Explanation explanation = explain(room(6), "across");
        assertEquals(2, explanation.without().size());
        assertFalse(explanation.without().get(0).isFound());
        assertTrue(explanation.without().get(0).reason().contains("with vault"), explanation.toString());
        assertEquals(List.of(), explanation.flips());
    }

    @Test
    void leavesFlipsOutWherePlansAreNotOfLeastCost() {
        Scene scene = room(4.98);
        Journey journey = (Journey) scene.tasks().get(0);
        Explanation explanation = explain(scene.with(journey.with(new Ordering.Bounded(1.5))), "across");
        assertEquals(2, explanation.without().size());
        assertEquals(List.of(), explanation.flips());
    }

    @Test
    void aPlanThatIsNotFoundHasNothingBesideIt() {
        Scene scene = preferring(room(6), "across", Ability.VAULT, Preferences.OFF);
        Explanation explanation = explain(scene, "across");
        assertFalse(explanation.plan().isFound());
        assertEquals(List.of(), explanation.without());
        assertEquals(List.of(), explanation.flips());
    }

    @Test
    void endsWhenItsPlanningIsCancelled() {
        Scene scene = room(4.98);
        Run run = plan(scene, "across");
        Explainer explainer = new Explainer((other, task) -> {
            Engine engine = Tasks.start(other, task);
            engine.cancel();
            return engine.run();
        });
        assertThrows(CancellationException.class, () -> explainer.explain(run));
    }

    @TestFactory
    List<DynamicTest> everyFlipOfTheSampleJourneysIsOne() throws IOException, SceneException {
        List<DynamicTest> tests = new ArrayList<>();
        List<Path> files;
        try (Stream<Path> found = Files.list(Path.of("scenes", "unified"))) {
            files = found.filter(f -> f.toString().endsWith(".xml")).sorted().toList();
        }
        for (Path file : files) {
            Scene scene = SceneXml.read(file).scene();
            for (Task task : scene.tasks()) {
                tests.add(DynamicTest.dynamicTest(
                        file.getFileName() + " " + task.id(),
                        () -> explain(scene, task.id()).flips().forEach(f -> assertFlips(scene, task.id(), f))));
            }
        }
        return tests;
    }

    /** Where an obstacle is put depends on the preferences, and is the best for itself, so that costs are not quite lines. */
    private static final double WHERE_TO_PUT = 0.01;

    private static void assertFlips(Scene scene, String task, Flip flip) {
        Preferences own = ((Journey) scene.task(task).orElseThrow()).preferences();
        double least = Double.NaN;
        for (double share : new double[] {0.99, 1, 1.01}) {
            double preference = share * flip.preference();
            Preferences there = own.with(flip.ability(), preference);
            Route route = new Route(Set.of(), plan(preferring(scene, task, flip.ability(), preference), task));
            double below = flip.below().cost(there);
            double above = flip.above().cost(there);
            least = route.cost(there);
            String name = flip.ability() + " x " + share + ": " + route.course() + " " + least;
            boolean moves = flip.below().used().contains(Ability.MOVE)
                    || flip.above().used().contains(Ability.MOVE);
            assertTrue(least <= Math.min(below, above) * (1 + (moves ? WHERE_TO_PUT : 1e-8)), name);
            if (share == 1) {
                assertEquals(least, below, 1e-6 * least, name);
                assertEquals(least, above, 1e-6 * least, name);
            } else {
                assertEquals(share < 1, below < above, name + ": " + below + ", " + above);
                boolean uses = route.used().contains(flip.ability());
                assertTrue(share < 1 ? uses : uses || flip.isGivenUp(), name);
                assertEquals(share > 1 && flip.isGivenUp(), !uses, name);
            }
        }
        assertFalse(
                flip.below().course().equals(flip.above().course()),
                flip.below().course().toString());
    }
}
