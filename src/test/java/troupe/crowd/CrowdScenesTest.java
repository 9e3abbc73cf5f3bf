package troupe.crowd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import troupe.geometry.Polygon;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.setting.Settings;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.search.Outcome;

/**
 * Runs the sample scenes, shortened where they are large, or with {@code -Dtroupe.crowd.whole=true} to their ends; the
 * tables of docs/crowd.md come from longer runs.
 */
class CrowdScenesTest {
    private static Scene set(Scene scene, String... settings) {
        Scene changed = scene;
        String task = scene.tasks().get(0).id();
        for (int i = 0; i < settings.length; i += 2) {
            changed = Settings.apply(changed, task, settings[i], settings[i + 1]);
        }
        return changed;
    }

    @ParameterizedTest
    @CsvSource({
        "fork,anticipate,90",
        "fork,paper,40",
        "narrow-bridge,anticipate,90",
        "narrow-bridge,paper,40",
        "two-ways,anticipate,30",
        "gate,anticipate,16",
        "army,anticipate,14"
    })
    void nobodyOverlapsOrStandsInAnObstacle(String name, String motion, String seconds)
            throws IOException, SceneException {
        Scene scene = set(CrowdEngineTest.scene(name), "motion", motion);
        if (!Boolean.getBoolean("troupe.crowd.whole")) {
            scene = set(scene, "seconds", seconds);
        }
        Run run = CrowdEngineTest.run(scene);
        assertTrue(run.frames().count() > 200, run.outcome().toString());
        assertEquals(Optional.empty(), new Legality(run).fault());
    }

    /** Counts the members of a group that take the branch to the left of the island. */
    private static int left(Run run, String group) {
        Frames frames = run.frames();
        int x = frames.channel(group, "x");
        int y = frames.channel(group, "y");
        int count = 0;
        for (int m = 0; m < 10; m++) {
            int frame = 0;
            while (frame < frames.count() - 1 && frames.value(frame, y, m) < 16.5) {
                frame++;
            }
            count += frames.value(frame, x, m) < 10 ? 1 : 0;
        }
        return count;
    }

    @Test
    void relatedGroupsPartAtTheForkAndMeetAtTheGoal() throws IOException, SceneException {
        for (String seed : List.of("1", "2", "3")) {
            Run run = CrowdEngineTest.run(set(CrowdEngineTest.scene("fork"), "seed", seed));
            assertEquals(10, Math.abs(left(run, "blue") - left(run, "black")), "seed " + seed);
            assertEquals(Outcome.FOUND, run.outcome(), "seed " + seed);
        }
    }

    @Test
    void withoutRelationVectorsTheyDoNotPart() throws IOException, SceneException {
        Scene scene = CrowdEngineTest.scene("fork");
        for (int depth = 0; depth <= 2; depth++) {
            for (String force : List.of("cohesion", "alignment", "separation")) {
                scene = set(scene, "relation." + depth + "." + force, "1");
            }
        }
        Run run = CrowdEngineTest.run(scene);
        assertTrue(Math.abs(left(run, "blue") - left(run, "black")) < 10);
    }

    @Test
    void opposingFlowsPassTheNarrowBridge() throws IOException, SceneException {
        for (String seed : List.of("1", "2", "3")) {
            Run run = CrowdEngineTest.run(set(CrowdEngineTest.scene("narrow-bridge"), "seed", seed));
            assertEquals(Outcome.FOUND, run.outcome(), "seed " + seed);
        }
    }

    @Test
    void squadsThatMaySplitAreThereSooner() throws IOException, SceneException {
        Scene scene = CrowdEngineTest.scene("two-ways");
        double[] last = new double[2];
        int k = 0;
        for (String split : List.of("static", "tree")) {
            Run run = CrowdEngineTest.run(set(scene, "split", split, "seed", "1"));
            assertEquals(Outcome.FOUND, run.outcome(), split);
            last[k++] = (double) run.report().values().get("last_arrival_s");
        }
        assertTrue(last[1] < last[0], last[1] + " s, static " + last[0] + " s");
    }

    @Test
    void stairsAndBridgesCarryAgents() throws IOException, SceneException {
        Scene layers = SceneXml.read(Path.of("scenes/unified/layers.xml")).scene();
        CrowdGroup over = CrowdGroup.of(
                "over", Place.of(18.5, 7), CrowdGroup.Members.of(6, Polygon.rectangle(0.5, 5.5, 2.8, 8.5)));
        CrowdGroup under =
                CrowdGroup.of("under", Place.of(10, 12), CrowdGroup.Members.of(6, Polygon.rectangle(8.4, 1, 11.6, 4)));
        Crowd crowd = Crowd.of("crowd", List.of(over, under)).lasting(90);
        Scene scene = new Scene("", layers.world(), layers.obstacles(), layers.ditches(), List.of(), List.of(crowd));
        Run run = CrowdEngineTest.run(scene);
        assertEquals(Outcome.FOUND, run.outcome());
        assertEquals(Optional.empty(), new Legality(run).fault());
        int z = run.frames().channel("over", "z");
        int low = run.frames().channel("under", "z");
        for (int m = 0; m < 6; m++) {
            double highest = 0;
            for (int frame = 0; frame < run.frames().count(); frame++) {
                highest = Math.max(highest, run.frames().value(frame, z, m));
                assertEquals(0, run.frames().value(frame, low, m), 1e-6);
            }
            assertEquals(2.6, highest, 1e-6);
        }
    }
}
