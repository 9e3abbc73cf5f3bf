package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JSlider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.run.Frames;
import troupe.run.Run;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Scene;
import troupe.scene.SceneXml;

/** Runs a crowd and an encounter in the real window, and takes part in them with the mouse. */
class SimulationRobotTest {
    @TempDir
    Path folder;

    private StudioFixture studio;

    @BeforeEach
    void open() throws Exception {
        Assumptions.assumeFalse(GraphicsEnvironment.isHeadless(), "skipped: there is no display");
        studio = new StudioFixture(folder);
    }

    @AfterEach
    void close() {
        if (studio != null) {
            studio.close();
        }
    }

    private void show(Scene scene) {
        OnEventThread.run(() -> studio.session().document().open(scene, java.util.Optional.empty()));
    }

    private Run run() {
        return OnEventThread.get(() -> studio.session().run().orElseThrow());
    }

    private void awaitEnd() {
        Await.until("the simulation has ended", () -> studio.session()
                .run()
                .filter(r -> !r.outcome().isRunning())
                .isPresent());
    }

    /** Returns the first frame in which two runs differ, or the number of frames that both have. */
    private static int firstDifference(Frames a, Frames b) {
        int both = Math.min(a.count(), b.count());
        for (int frame = 0; frame < both; frame++) {
            for (int c = 0; c < a.channels().size(); c++) {
                for (int k = 0; k < a.channels().get(c).width(); k++) {
                    if (Double.compare(a.value(frame, c, k), b.value(frame, c, k)) != 0) {
                        return frame;
                    }
                }
            }
        }
        return both;
    }

    @Test
    void aSliderMovedWhileACrowdRunsChangesWhatFollowsOnly() throws Exception {
        show(SceneXml.read(Path.of("scenes/crowd/fork.xml")).scene());
        awaitEnd();
        Run before = run();
        OnEventThread.run(() -> studio.session().playback().seek(4));
        JSlider slider = (JSlider) studio.find("control.weight.cohesion");
        Point knob = new Point(slider.getWidth() * slider.getValue() / slider.getMaximum(), slider.getHeight() / 2);
        studio.drag(slider, knob, new Point(slider.getWidth() - 10, knob.y));
        Await.until("another run has ended", () -> studio.session()
                .run()
                .filter(r -> !r.outcome().isRunning() && !r.inputs().isEmpty())
                .isPresent());
        Run after = run();
        assertEquals("weight.cohesion", after.inputs().get(0).key());
        int first = firstDifference(before.frames(), after.frames());
        assertTrue(first > 4 * before.frames().rate(), "frame " + first);
        assertTrue(first < before.frames().count(), "frame " + first);
    }

    @Test
    void anAvatarFollowsThePointerAndTheActorGivesWay() throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/risk/steering.xml")).scene();
        show(scene);
        awaitEnd();
        Run alone = run();
        Encounter encounter = (Encounter) scene.tasks().get(0);
        Avatar avatar = encounter.avatars().stream()
                .filter(a -> a.motion() instanceof Avatar.Pointer)
                .findFirst()
                .orElseThrow();
        Avatar.Pointer pointer = (Avatar.Pointer) avatar.motion();
        Point from = studio.pixel(pointer.start().x(), pointer.start().y());
        OnEventThread.run(() -> studio.session().playback().seek(0));
        Point to = studio.pixel(
                (encounter.start().x() + encounter.goal().x()) / 2,
                (encounter.start().y() + encounter.goal().y()) / 2);
        studio.pressAndMove(studio.window().canvas(), from, to);
        Await.until(
                "it has been steered for two seconds",
                () -> studio.session().playback().time() > 2);
        studio.release();
        awaitEnd();
        Run steered = run();
        assertTrue(steered.outcome().isFound(), steered.outcome().word());
        assertNotEquals(List.of(), steered.inputs());
        assertTrue(
                way(steered, encounter.actor()) > way(alone, encounter.actor()) + 0.02,
                way(alone, encounter.actor()) + " to " + way(steered, encounter.actor()));
        studio.keys(KeyEvent.VK_SPACE);
    }

    private static double way(Run run, String actor) {
        Frames frames = run.frames();
        int x = frames.channel(actor, "x");
        int y = frames.channel(actor, "y");
        double way = 0;
        for (int f = 1; f < frames.count(); f++) {
            way += Math.hypot(
                    frames.value(f, x, 0) - frames.value(f - 1, x, 0),
                    frames.value(f, y, 0) - frames.value(f - 1, y, 0));
        }
        return way;
    }
}
