package troupe.unified;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import troupe.run.Digest;
import troupe.run.Run;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;

/** Plans every journey of the sample scenes: each is solved, free of collisions frame by frame, and the same every time. */
class SampleJourneysTest {
    private static final Path FOLDER = Path.of("scenes", "unified");

    @TestFactory
    List<DynamicTest> everySampleJourney() throws IOException, SceneException {
        List<DynamicTest> tests = new ArrayList<>();
        List<Path> files;
        try (Stream<Path> found = Files.list(FOLDER)) {
            files = found.filter(f -> f.toString().endsWith(".xml")).sorted().toList();
        }
        assertTrue(files.size() >= 9, files.toString());
        for (Path file : files) {
            Scene scene = SceneXml.read(file).scene();
            for (Task task : scene.tasks()) {
                String name = file.getFileName() + " " + task.id();
                tests.add(DynamicTest.dynamicTest(name, () -> solves(scene, (Journey) task, name)));
            }
        }
        return tests;
    }

    private static void solves(Scene scene, Journey journey, String name) {
        JourneyEngine engine = JourneyEngine.of(scene, journey);
        Run run = engine.finish();
        assertTrue(run.outcome().isFound(), name + ": " + run.outcome());
        Actor actor = scene.actor(journey.actor()).orElseThrow();
        RunCheck.assertKeepsRadius(run, actor, name);
        PushCheck.assertFree(run, actor, engine.path().orElseThrow(), name);
        Run again = JourneyEngine.of(scene, journey).finish();
        assertEquals(Digest.of(run.frames()), Digest.of(again.frames()), name);
        double smoothed = (double) run.report().values().get("smoothed_length");
        double length = (double) run.report().values().get("length");
        assertTrue(smoothed <= 1.02 * length, name + ": " + smoothed + " of " + length);
    }
}
