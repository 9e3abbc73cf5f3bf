package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import troupe.app.document.SceneDocument;
import troupe.run.Run;
import troupe.run.RunComparison;
import troupe.run.Simulation;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.run.file.RunJournal;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;
import troupe.work.KilledRuns;
import troupe.work.Tasks;

/** Kills a studio while a person works in it, and opens another one. */
class RecoveryRobotTest extends RobotTest {
    private Path file;
    private Scene saved;

    @Override
    void begin() throws Exception {
        file = Files.copy(Path.of(Studio.DEFAULT_SCENE), folder.resolve("courtyard.xml"));
        saved = SceneXml.read(file).scene();
    }

    private static String classes(Class<?> type) throws URISyntaxException {
        return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI())
                .toString();
    }

    private List<Path> kept() {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(f -> f.getFileName().toString().endsWith(".troupe"))
                    .toList();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /** Drags the crate aside in a studio of its own, and kills that while the next drag is under way. */
    private void editAndKill() throws Exception {
        Process child = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        String.join(java.io.File.pathSeparator, classes(Studio.class), classes(DoomedStudio.class)),
                        DoomedStudio.class.getName(),
                        file.toString(),
                        folder.resolve("recovery").toString(),
                        "8.125",
                        "7.6",
                        "5.5",
                        "9.5",
                        "4.5",
                        "6.5")
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        Robot robot = new Robot();
        robot.setAutoDelay(15);
        try (BufferedReader told = child.inputReader(StandardCharsets.UTF_8)) {
            int[] at = Arrays.stream(told.readLine().split(" "))
                    .mapToInt(Integer::parseInt)
                    .toArray();
            press(robot, at[0], at[1], at[2], at[3]);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            Await.until("the edit is kept", () -> !kept().isEmpty());
            press(robot, at[2], at[3], at[4], at[5]);
        } finally {
            child.destroyForcibly();
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        }
        assertTrue(child.waitFor(30, TimeUnit.SECONDS));
        assertEquals(saved, SceneXml.read(file).scene());
    }

    private static void press(Robot robot, int fromX, int fromY, int toX, int toY) {
        robot.mouseMove(fromX, fromY);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        for (int i = 1; i <= 8; i++) {
            robot.mouseMove(fromX + (toX - fromX) * i / 8, fromY + (toY - fromY) * i / 8);
        }
    }

    private SceneDocument document() {
        return studio.session().document();
    }

    @Test
    void editsOfAKilledStudioAreRestoredAndCanBeUndoneAndSaved() throws Exception {
        editAndKill();
        Path kept = kept().get(0);
        Scene edited = SceneXml.read(kept).scene();
        assertNotEquals(saved, edited);
        studio = new StudioFixture(folder, file, Map.of());
        Await.until("recovery is offered", () -> studio.shows("recovery.restore"));
        studio.click("recovery.restore");
        Await.until("restored", () -> document().scene().equals(edited));
        assertTrue(OnEventThread.get(() -> document().isUnsaved()));
        assertEquals(Optional.of(file), OnEventThread.get(() -> document().file()));
        assertEquals(
                List.of("Restore unsaved edits"),
                OnEventThread.get(() -> document().history().names()));
        Await.until("kept by this studio now", () -> !kept().contains(kept) && kept().size() == 1);
        // without a window manager the keys stay with the dialog that is gone
        studio.click(studio.window().canvas(), studio.window().canvas().getWidth() - 3, 200);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        Await.until("undone", () -> document().scene().equals(saved));
        Await.until("nothing is kept of a saved scene", () -> kept().isEmpty());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        Await.until("saved", () -> !document().isUnsaved());
        assertEquals(edited, SceneXml.read(file).scene());
        Await.until("nothing is kept", () -> kept().isEmpty());
    }

    private static Run read(Path journal) {
        try {
            return RunFile.read(journal);
        } catch (RunException | IOException e) {
            return null; // not begun yet
        }
    }

    private List<Path> journals() {
        Path recovery = folder.resolve("recovery");
        if (!Files.isDirectory(recovery)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(recovery)) {
            return files.filter(f -> f.getFileName().toString().endsWith(".journal"))
                    .toList();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /** Kills a studio of its own while it simulates a crowd; returns how many frames it had kept for sure. */
    private int simulateAndKill(Path crowd) throws Exception {
        Process child = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        String.join(java.io.File.pathSeparator, classes(Studio.class), classes(DoomedStudio.class)),
                        DoomedStudio.class.getName(),
                        crowd.toString(),
                        folder.resolve("recovery").toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        int[] frames = {0};
        try {
            Await.until("some frames are kept", () -> {
                for (Path journal : journals()) {
                    Run run = read(journal);
                    frames[0] = run == null ? 0 : run.frames().count();
                }
                return frames[0] >= 50;
            });
        } finally {
            child.destroyForcibly();
        }
        assertTrue(child.waitFor(30, TimeUnit.SECONDS));
        return frames[0];
    }

    @Test
    void theSimulationOfAKilledStudioIsShownAsFarAsItWasKept() throws Exception {
        Path crowd = folder.resolve("crowd.xml");
        SceneXml.write(KilledRuns.scene(300, 7200), crowd);
        int frames = simulateAndKill(crowd);
        studio = new StudioFixture(folder, file, Map.of());
        Await.until("it is offered", () -> studio.shows("recovery.run.restore"));
        studio.click("recovery.run.restore");
        Await.until("shown", () -> OnEventThread.get(() -> studio.session().run())
                .filter(RunJournal::recovered)
                .isPresent());
        Run run = OnEventThread.get(() -> studio.session().run()).orElseThrow();
        assertTrue(run.frames().count() >= frames, run.frames().count() + " of " + frames);
        Simulation again = (Simulation) Tasks.start(run.scene(), run.task());
        again.step(frames);
        assertEquals(Optional.empty(), RunComparison.firstDifference(again.run().frames(), run.frames(), frames));
        OnEventThread.run(() -> studio.window().dispose());
        Await.until("nothing is kept", () -> journals().isEmpty());
    }

    @Test
    void discardedEditsAreGoneAndTheSceneStays() throws Exception {
        editAndKill();
        studio = new StudioFixture(folder, file, Map.of());
        Await.until("recovery is offered", () -> studio.shows("recovery.discard"));
        studio.click("recovery.discard");
        Await.until("nothing is kept", () -> kept().isEmpty());
        assertEquals(saved, studio.scene());
    }
}
