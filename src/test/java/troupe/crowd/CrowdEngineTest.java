package troupe.crowd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import troupe.crowd.flock.Sweep;
import troupe.geometry.Polygon;
import troupe.run.Digest;
import troupe.run.Run;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.search.Outcome;

class CrowdEngineTest {
    /** A hall of 16 by 10 m with a pillar, and two groups that change sides. */
    private static Scene hall(int each, double seconds) {
        CrowdGroup left = CrowdGroup.of(
                "left", Place.of(14, 5), CrowdGroup.Members.of(each, Polygon.rectangle(0.5, 0.5, 5, 9.5)));
        CrowdGroup right = CrowdGroup.of(
                "right", Place.of(2, 5), CrowdGroup.Members.of(each, Polygon.rectangle(11, 0.5, 15.5, 9.5)));
        Crowd crowd = Crowd.of("swap", List.of(left, right)).lasting(seconds);
        Obstacle pillar = new Obstacle("pillar", "", Polygon.rectangle(7.5, 4, 8.5, 6), 0, 3, false, 20, "");
        return new Scene("", new World(16, 10, 0.1), List.of(pillar), List.of(), List.of(), List.of(crowd));
    }

    private static CrowdEngine engine(Scene scene, Sweep sweep) {
        return new CrowdEngine(scene, (Crowd) scene.tasks().get(0), sweep);
    }

    static Run run(Scene scene) {
        return engine(scene, Sweep.alone()).finish();
    }

    static Scene scene(String name) throws IOException, SceneException {
        return SceneXml.read(Path.of("scenes/crowd/" + name + ".xml")).scene();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 20, 80, 150})
    void nobodyOverlapsAtAnyDensity(int each) {
        Run run = run(hall(each, 20));
        assertEquals(Optional.empty(), new Legality(run).fault());
        assertTrue(run.frames().count() > 100, run.outcome().toString());
    }

    /** In a pack the directions change from step to step; people that are shown so look as if they trembled. */
    @Test
    void nobodyIsShownToTurnFasterThanABody() {
        Run run = run(hall(80, 12));
        int heading = run.frames().channel("left", "heading");
        for (int frame = 1; frame < run.frames().count(); frame++) {
            for (int m = 0; m < 80; m++) {
                double turn =
                        run.frames().value(frame, heading, m) - run.frames().value(frame - 1, heading, m);
                double least = Math.abs(StrictMath.IEEEremainder(turn, 2 * Math.PI));
                assertTrue(least <= Math.PI * Crowd.STEP_SECONDS + 1e-5, "frame " + frame + ", agent " + m);
            }
        }
    }

    @Test
    void theNumberOfThreadsDoesNotMatter() {
        String alone = Digest.of(run(hall(150, 8)).frames());
        for (int threads : new int[] {2, 16}) {
            ForkJoinPool pool = new ForkJoinPool(threads);
            try {
                assertEquals(
                        alone,
                        Digest.of(engine(hall(150, 8), Sweep.on(pool)).finish().frames()));
            } finally {
                pool.shutdown();
            }
        }
    }

    @Test
    void slicedEqualsWhole() {
        String whole = Digest.of(run(hall(30, 10)).frames());
        for (int budget : new int[] {1, 7}) {
            CrowdEngine engine = engine(hall(30, 10), Sweep.alone());
            while (engine.step(budget).isRunning()) {
                assertEquals(0, engine.progress().work() % budget);
            }
            assertEquals(whole, Digest.of(engine.run().frames()));
        }
    }

    @Test
    void inputTakesEffectFromItsStepAndIsReplayed() {
        CrowdEngine plain = engine(hall(10, 6), Sweep.alone());
        CrowdEngine steered = engine(hall(10, 6), Sweep.alone());
        plain.step(50);
        steered.step(50);
        steered.give(new Run.Input(60, "weight.separation", 5));
        Run changed = steered.finish();
        Run same = plain.finish();
        assertEquals(1, changed.inputs().size());
        int x = changed.frames().channel("left", "x");
        for (int frame = 0; frame < 60; frame++) {
            assertEquals(same.frames().value(frame, x, 3), changed.frames().value(frame, x, 3));
        }
        assertTrue(!Digest.of(same.frames()).equals(Digest.of(changed.frames())));
        CrowdEngine again = engine(hall(10, 6), Sweep.alone());
        changed.inputs().forEach(again::give);
        assertEquals(Digest.of(changed.frames()), Digest.of(again.finish().frames()));
    }

    @Test
    void refusesInputThatIsUnknownOutOfRangeOrPast() {
        CrowdEngine engine = engine(hall(2, 6), Sweep.alone());
        engine.step(10);
        for (Run.Input wrong : List.of(
                new Run.Input(10, "weight.gravity", 1),
                new Run.Input(10, "weight.separation", -1),
                new Run.Input(10, "weight.separation", Double.NaN),
                new Run.Input(9, "weight.separation", 1))) {
            assertThrows(IllegalArgumentException.class, () -> engine.give(wrong), wrong.toString());
        }
        assertTrue(engine.run().inputs().isEmpty());
        assertEquals(5 + 3 * 2, engine.controls().size());
    }

    @Test
    void saysWhichGroupHasNoRoom() {
        Run run = run(hall(400, 6));
        assertTrue(
                run.outcome() instanceof Outcome.Infeasible none
                        && none.reason().contains("'left' has room for"),
                run.outcome().toString());
    }

    @Test
    void everybodyArrivesAndReportsSo() {
        Run run = run(hall(8, 60));
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(16L, run.report().values().get("arrived"));
        double mean = (double) run.report().values().get("mean_travel_s");
        // 9 to 12 m at 1.3 m/s, and what passing each other takes
        assertTrue(mean > 6 && mean < 20, "mean " + mean);
    }

    /** A door once locked: those who had settled in a queue before the goal shut it for all others. */
    @Test
    void everybodyPassesTheDoorAndSettlesBehindIt() {
        CrowdGroup all = CrowdGroup.of(
                "all", Place.of(15, 5), CrowdGroup.Members.of(120, Polygon.rectangle(0.5, 0.5, 9.5, 9.5)));
        Crowd crowd = Crowd.of("leave", List.of(all)).lasting(200);
        List<Obstacle> walls = List.of(
                new Obstacle("below", "", Polygon.rectangle(10, 0, 10.4, 4.5), 0, 3, false, 20, ""),
                new Obstacle("above", "", Polygon.rectangle(10, 5.5, 10.4, 10), 0, 3, false, 20, ""));
        Run run = run(new Scene("", new World(20, 10, 0.1), walls, List.of(), List.of(), List.of(crowd)));
        assertEquals(Outcome.FOUND, run.outcome(), run.report().values().toString());
        assertEquals(Optional.empty(), new Legality(run).fault());
        int x = run.frames().channel("all", "x");
        for (int m = 0; m < 120; m++) {
            assertTrue(run.frames().value(run.frames().count() - 1, x, m) > 10.4, "agent " + m);
        }
    }
}
