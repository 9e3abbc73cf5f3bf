package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import javax.swing.JSlider;
import org.junit.jupiter.api.Test;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Runs a crowd and an encounter in the real window, and takes part in them with the mouse. */
class SimulationRobotTest extends RobotTest {
    private void show(Scene scene) {
        OnEventThread.run(() -> studio.session().document().open(scene, java.util.Optional.empty()));
    }

    private Run run() {
        return OnEventThread.get(() -> studio.session().run().orElseThrow());
    }

    private void awaitEnd() {
        Await.until("the simulation has ended", () -> studio.session()
                .run()
                .filter(r -> r.scene().equals(studio.session().document().scene()))
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
        OnEventThread.run(() -> {
            studio.session().playback().seek(0);
            // slowly, so that a busy machine has moved the mouse before the actor is there
            studio.session().playback().setSpeed(0.5);
        });
        Frames before = alone.frames();
        int middle = before.count() / 2;
        Point to = studio.pixel(
                before.value(middle, before.channel(encounter.actor(), "x"), 0),
                before.value(middle, before.channel(encounter.actor(), "y"), 0));
        studio.pressAndMove(studio.window().canvas(), from, to);
        Await.until(
                "it has been steered for a second",
                () -> studio.session().playback().time() > 1);
        studio.release();
        awaitEnd();
        Run steered = run();
        assertTrue(steered.outcome().isFound(), steered.outcome().word());
        assertNotEquals(List.of(), steered.inputs());
        Frames frames = steered.frames();
        double followed =
                apart(frames, avatar.id(), alone.frames(), avatar.id()).max().orElse(0);
        assertTrue(followed > 0.5, "the avatar went " + followed + " m");
        double nearest =
                apart(frames, encounter.actor(), frames, avatar.id()).min().orElse(0);
        double turned = apart(frames, encounter.actor(), alone.frames(), encounter.actor())
                .max()
                .orElse(0);
        assertTrue(
                turned > 0.05,
                "the actor went " + turned + " m from its way, " + nearest + " m from the other, inputs "
                        + steered.inputs());
    }

    @Test
    void theInspectorTellsWhomThePlanOfTheMomentMayMeet() throws Exception {
        show(SceneXml.read(Path.of("scenes/risk/crossing.xml")).scene());
        awaitEnd();
        OnEventThread.run(() -> studio.session().playback().seek(2.8));
        Await.until("Bob is told of", () -> OnEventThread.get(() -> said().startsWith("Bob: ")));
        String before = OnEventThread.get(this::said);
        OnEventThread.run(() -> studio.session().playback().seek(3.2));
        Await.until("it follows the moment", () -> OnEventThread.get(() -> !said().equals(before)));
        String status = OnEventThread.get(() -> ((javax.swing.JLabel) studio.find("status.happened")).getText());
        assertTrue(status.startsWith("Arrived after "), status);
        OnEventThread.run(() -> studio.session().playback().seek(0));
        show(SceneXml.read(Path.of("scenes/crowd/fork.xml")).scene());
        Await.until(
                "crowds have none",
                () -> OnEventThread.get(() -> !studio.find("foresight").isVisible()));
    }

    private String said() {
        String said = studio.find("foresight.strips").getAccessibleContext().getAccessibleName();
        return said == null ? "" : said;
    }

    /** Returns how far one is in a run from one in another, in metres, for each frame that both runs have. */
    private static DoubleStream apart(Frames a, String one, Frames b, String other) {
        int ax = a.channel(one, "x");
        int ay = a.channel(one, "y");
        int bx = b.channel(other, "x");
        int by = b.channel(other, "y");
        return IntStream.range(0, Math.min(a.count(), b.count()))
                .mapToDouble(
                        f -> Math.hypot(a.value(f, ax, 0) - b.value(f, bx, 0), a.value(f, ay, 0) - b.value(f, by, 0)));
    }
}
