package troupe.app.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.document.SceneDocument.Change;
import troupe.scene.Scene;

class SceneDocumentTest {
    private static final Path FILE = Path.of("room.xml");

    private static SceneDocument document(Scene scene) {
        return new SceneDocument(scene, Optional.of(FILE));
    }

    private static Scene moved(Scene scene, double dx) {
        return SceneEdits.shifted(scene, List.of("crate"), dx, 0);
    }

    @Test
    void refusesOtherThreads() {
        assertThrows(IllegalStateException.class, () -> document(Scenes.room()));
        SceneDocument document = OnEventThread.get(() -> document(Scenes.room()));
        assertThrows(IllegalStateException.class, () -> document.commit("x", moved(document.scene(), 1)));
    }

    @Test
    void previewShowsAndLeavesNoTrace() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            Scene before = document.scene();
            document.preview(moved(before, 1));
            document.preview(moved(before, 2));
            assertEquals(moved(before, 2), document.shown());
            assertSame(before, document.scene());
            assertEquals(2, document.version().preview());
            document.dropPreview();
            assertSame(before, document.shown());
            assertFalse(document.isUnsaved());
            assertFalse(document.history().canUndo());
        });
    }

    @Test
    void commitIsOneNamedStepAndEndsThePreview() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            Scene before = document.scene();
            document.preview(moved(before, 1));
            document.commit("Move crate", moved(before, 2));
            assertFalse(document.isPreviewing());
            assertEquals(List.of("Move crate"), document.history().names());
            assertTrue(document.isUnsaved());
            document.history().stepBack();
            assertSame(before, document.scene());
            assertFalse(document.isUnsaved());
            assertEquals("Move crate", document.history().redoName());
        });
    }

    @Test
    void commitOfTheSameSceneMakesNoStep() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            document.preview(moved(document.scene(), 1));
            document.commit("Nothing", moved(document.scene(), 0));
            assertEquals(List.of(), document.history().names());
            assertFalse(document.isPreviewing());
        });
    }

    @Test
    void versionsOnlyGrow() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            List<Version> versions = new ArrayList<>(List.of(document.version()));
            document.listeners().add(change -> {
                if (change != Change.FILE) {
                    assertTrue(document.version().compareTo(versions.get(versions.size() - 1)) > 0);
                    versions.add(document.version());
                }
            });
            Scene start = document.scene();
            document.preview(moved(start, 1));
            document.preview(moved(start, 2));
            document.dropPreview();
            document.commit("a", moved(start, 3));
            document.history().stepBack();
            document.history().stepForward();
            document.lookAt("back");
            document.open(Scenes.room(), Optional.empty());
            assertEquals(9, versions.size());
        });
    }

    @Test
    void undoAllEqualsTheStartAndRedoAllTheEnd() {
        long seed = Long.getLong("seed", 11);
        OnEventThread.run(() -> {
            Random random = new Random(seed);
            SceneDocument document = document(Scenes.room());
            Scene start = document.scene();
            List<Scene> states = new ArrayList<>(List.of(start));
            for (int i = 0; i < 1_200; i++) {
                document.commit("step " + i, moved(document.scene(), 0.5 - random.nextDouble()));
                states.add(document.scene());
            }
            Scene end = document.scene();
            assertEquals(1_200, document.history().names().size(), "seed " + seed);
            for (int i = states.size() - 2; i >= 0; i--) {
                document.history().stepBack();
                assertSame(states.get(i), document.scene(), "seed " + seed);
            }
            assertFalse(document.history().canUndo());
            assertEquals(0, document.history().position());
            document.history().jump(1_200);
            assertSame(end, document.scene());
            document.history().jump(600);
            assertSame(states.get(600), document.scene());
            document.commit("other", moved(document.scene(), 1));
            assertEquals(601, document.history().names().size());
            assertFalse(document.history().redoAction().isEnabled());
        });
    }

    @Test
    void savingMovesTheMarkEvenWhenEditedMeanwhile() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            document.commit("a", moved(document.scene(), 1));
            Scene written = document.scene();
            document.commit("b", moved(document.scene(), 1));
            document.savedAs(Path.of("other.xml"), written);
            assertTrue(document.isUnsaved());
            assertEquals(Optional.of(Path.of("other.xml")), document.file());
            document.history().stepBack();
            assertFalse(document.isUnsaved());
            document.history().stepBack();
            assertTrue(document.isUnsaved());
        });
    }

    @Test
    void openingForgetsTheHistory() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            document.commit("a", moved(document.scene(), 1));
            document.open(Scenes.room(), Optional.empty());
            assertFalse(document.history().canUndo());
            assertFalse(document.isUnsaved());
            assertEquals("there", document.task());
        });
    }

    @Test
    void looksAtTasksOfTheSceneOnly() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            document.lookAt("back");
            assertEquals("back", document.shownTask().orElseThrow().id());
            assertThrows(IllegalArgumentException.class, () -> document.lookAt("nowhere"));
        });
    }

    @Test
    void undoActionsFollowTheHistory() {
        OnEventThread.run(() -> {
            SceneDocument document = document(Scenes.room());
            UndoHistory history = document.history();
            assertFalse(history.undoAction().isEnabled());
            document.commit("Move crate", moved(document.scene(), 1));
            assertTrue(history.undoAction().isEnabled());
            history.undoAction().actionPerformed(null);
            assertFalse(history.undoAction().isEnabled());
            assertTrue(history.redoAction().isEnabled());
            history.redoAction().actionPerformed(null);
            assertEquals("Move crate", history.undoName());
        });
    }
}
