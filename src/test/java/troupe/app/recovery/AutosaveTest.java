package troupe.app.recovery;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.app.session.SceneFiles;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;

class AutosaveTest {
    @TempDir
    Path folder;

    private Path file;
    private KeptFiles kept;
    private SceneDocument document;
    private Autosave autosave;

    private static final SceneFiles FILES = new SceneFiles() {
        @Override
        public Scene read(Path from) throws SceneException, IOException {
            return SceneXml.read(from).scene();
        }

        @Override
        public Scene convert(Path from) throws IOException {
            throw new IOException(from + ": not a scene");
        }

        @Override
        public void write(Scene scene, Path to) throws IOException {
            assertFalse(EventQueue.isDispatchThread());
            SceneXml.write(scene, to);
        }
    };

    @BeforeEach
    void begin() throws IOException {
        file = folder.resolve("room.xml");
        SceneXml.write(Scenes.room(), file);
        kept = new KeptFiles(folder.resolve("recovery"));
        begin(Optional.of(file));
    }

    private void begin(Optional<Path> belongs) {
        document = OnEventThread.get(() -> new SceneDocument(Scenes.room(), belongs));
        autosave = OnEventThread.get(() -> new Autosave(document, FILES, kept, e -> {
            throw new AssertionError(e);
        }));
    }

    @AfterEach
    void end() {
        OnEventThread.run(autosave::close);
    }

    private void edit() {
        OnEventThread.run(() ->
                document.commit("Move", SceneEdits.shifted(document.scene(), java.util.List.of("crate"), 0.5, 0)));
    }

    private void awaitKept(Path slot) {
        Await.until("kept", () -> Files.exists(slot));
    }

    private static void awaitGone(Path slot) {
        Await.until("gone", () -> !Files.exists(slot));
    }

    @Test
    void anEditIsKeptBesideTheFileByItselfAndTheFileStays() throws Exception {
        edit();
        Path slot = kept.slot(Optional.of(file));
        assertEquals(folder, slot.getParent());
        assertTrue(slot.getFileName().toString().startsWith("."));
        awaitKept(slot);
        assertEquals(document.scene(), SceneXml.read(slot).scene());
        assertEquals(Scenes.room(), SceneXml.read(file).scene());
    }

    @Test
    void whatIsSavedUndoneOrGivenUpIsKeptNoMore() {
        Path slot = kept.slot(Optional.of(file));
        edit();
        OnEventThread.run(autosave::keep);
        awaitKept(slot);
        OnEventThread.run(() -> document.savedAs(file, document.scene()));
        awaitGone(slot);
        edit();
        OnEventThread.run(autosave::keep);
        awaitKept(slot);
        OnEventThread.run(() -> document.history().stepBack());
        awaitGone(slot);
        edit();
        OnEventThread.run(autosave::keep);
        awaitKept(slot);
        OnEventThread.run(() -> document.open(Scenes.room(), Optional.empty()));
        awaitGone(slot);
        edit();
        OnEventThread.run(autosave::keep);
        Path unnamed = kept.slot(Optional.empty());
        awaitKept(unnamed);
        OnEventThread.run(autosave::close);
        awaitGone(unnamed);
    }

    @Test
    void aDocumentWithoutAFileIsKeptInTheFolderOfThePerson() {
        OnEventThread.run(autosave::close);
        begin(Optional.empty());
        edit();
        OnEventThread.run(autosave::keep);
        Path slot = kept.slot(Optional.empty());
        assertEquals(folder.resolve("recovery"), slot.getParent());
        awaitKept(slot);
    }

    @Test
    void whatIsKeptUnderAnotherNameGoesWithTheOldName() {
        edit();
        OnEventThread.run(autosave::keep);
        awaitKept(kept.slot(Optional.of(file)));
        OnEventThread.run(() -> document.savedAs(folder.resolve("other.xml"), Scenes.room()));
        awaitGone(kept.slot(Optional.of(file)));
        OnEventThread.run(autosave::keep);
        awaitKept(kept.slot(Optional.of(folder.resolve("other.xml"))));
    }
}
