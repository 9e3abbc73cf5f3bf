package troupe.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;

class ChronicleTest {

    @Test
    void tellsOfTheTimeThatThereWasWhenItWasMade() throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/risk/crossing.xml")).scene();
        Engine engine = Tasks.start(scene, "cross");
        engine.step(31);
        Run run = engine.run();
        Chronicle chronicle = Chronicle.of(run, new double[0]).orElseThrow();
        assertEquals(1, chronicle.seconds(), 1e-9);
        List<Chronicle.Mark> marks = chronicle.marks();
        assertEquals("replanned", marks.get(0).word());
        assertEquals(0, marks.get(0).begin());
        for (int k = 1; k < marks.size(); k++) {
            assertEquals(marks.get(k - 1).end(), marks.get(k).begin());
        }
        assertEquals(1, marks.get(marks.size() - 1).end(), 1e-9);
        assertEquals(31, chronicle.curves().get(0).values().length);
        assertTrue(
                Chronicle.of(Tasks.start(scene, "cross").run(), new double[0]).isEmpty());
    }
}
