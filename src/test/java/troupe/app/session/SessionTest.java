package troupe.app.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.ScriptedSteps;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.exchange.format.ExchangeException;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

class SessionTest implements SceneFiles {
    private static final Path FILE = Path.of("room.xml");

    private final Map<Path, Scene> disk = new ConcurrentHashMap<>();
    private final ScriptedSteps steps = new ScriptedSteps(2, () -> {});
    private final List<Notice> notices = new ArrayList<>();
    private Session session;

    @Override
    public Scene read(Path file) throws SceneException, IOException {
        if (file.endsWith("broken.xml")) {
            throw new SceneException("broken.xml", 3, "obstacle 'a' has no points", "give it points");
        }
        if (!disk.containsKey(file)) {
            throw new IOException(file + ": not found");
        }
        return disk.get(file);
    }

    @Override
    public Scene convert(Path file) throws ExchangeException, IOException {
        if (file.endsWith("broken.map")) {
            throw new ExchangeException("broken.map", 4, 0, "a row of 3 cells", "give 4, as the width says");
        }
        return disk.get(file);
    }

    @Override
    public void write(Scene scene, Path file) throws IOException {
        if (file.startsWith("full")) {
            throw new IOException("no space left");
        }
        disk.put(file, scene);
    }

    @BeforeEach
    void begin() {
        session = OnEventThread.get(() -> {
            SceneDocument document = new SceneDocument(Scenes.room(), Optional.of(FILE));
            Session made = new Session(document, steps, this, EventQueue::invokeLater);
            made.notices().add(notices::add);
            return made;
        });
    }

    @AfterEach
    void end() {
        session.close();
    }

    private void move() {
        OnEventThread.run(() -> session.document()
                .commit("Move", SceneEdits.shifted(session.document().scene(), List.of("crate"), 1, 0)));
    }

    private void awaitPlan() {
        Await.until("a plan of the present version", () -> session.plan()
                .filter(p -> p.snapshot().version().equals(session.document().version()))
                .isPresent());
    }

    @Test
    void everyChangeAsksForAPlan() {
        move();
        awaitPlan();
        assertSame(
                session.document().scene(),
                session.plan().orElseThrow().snapshot().scene());
        OnEventThread.run(() -> session.document().history().stepBack());
        awaitPlan();
        OnEventThread.run(() -> session.document().lookAt("back"));
        awaitPlan();
        assertEquals("back", session.plan().orElseThrow().snapshot().task());
    }

    @Test
    void planningWaitsWhileItIsNotLive() {
        OnEventThread.run(() -> session.setLive(false));
        move();
        OnEventThread.run(() -> assertTrue(session.plan().isEmpty()));
        assertEquals(0, steps.started());
        OnEventThread.run(() -> session.setLive(true));
        awaitPlan();
    }

    @Test
    void savesAndOpens() {
        move();
        Path other = Path.of("other.xml");
        OnEventThread.run(() -> session.save(other));
        Await.until("saved", () -> !session.document().isUnsaved());
        assertSame(session.document().scene(), disk.get(other));
        assertEquals(Optional.of(other), session.document().file());
        disk.put(FILE, Scenes.room());
        OnEventThread.run(() -> session.selection().set(List.of("crate")));
        OnEventThread.run(() -> session.open(FILE));
        Await.until("opened", () -> session.document().file().equals(Optional.of(FILE)));
        assertEquals(Scenes.room(), session.document().scene());
        assertEquals(List.of(), session.selection().ids());
        awaitPlan();
    }

    @Test
    void whatIsImportedIsOneStepOfTheHistory() {
        Scene before = session.document().scene();
        Path map = Path.of("arena.map");
        disk.put(map, new Scene("arena", Scenes.room().world(), List.of(), List.of(), List.of(), List.of()));
        List<String> done = new ArrayList<>();
        OnEventThread.run(() -> session.importFrom(map, "Import arena.map", () -> done.add("then")));
        Await.until("imported", () -> done.size() == 1);
        assertEquals(disk.get(map), session.document().scene());
        assertTrue(session.document().isUnsaved());
        assertEquals(Optional.of(FILE), session.document().file());
        OnEventThread.run(() -> session.document().history().stepBack());
        assertEquals(before, session.document().scene());
        OnEventThread.run(() -> session.document().history().stepForward());
        assertEquals(disk.get(map), session.document().scene());
    }

    @Test
    void whatCannotBeImportedLeavesTheDocumentAndSaysWhy() {
        Scene before = session.document().scene();
        OnEventThread.run(() -> session.importFrom(Path.of("broken.map"), "Import", () -> {
            throw new AssertionError("nothing was imported");
        }));
        Await.until("a notice", () -> notices.size() == 1);
        assertEquals(
                "broken.map:4: a row of 3 cells; give 4, as the width says",
                notices.get(0).text());
        assertSame(before, session.document().scene());
    }

    @Test
    void aFileThatCannotBeReadLeavesTheDocumentAndSaysWhy() {
        Scene before = session.document().scene();
        OnEventThread.run(() -> session.open(Path.of("broken.xml")));
        Await.until("a notice", () -> notices.size() == 1);
        assertTrue(notices.get(0).wrong());
        assertTrue(
                notices.get(0).text().contains("obstacle 'a' has no points"),
                notices.get(0).text());
        OnEventThread.run(() -> session.open(Path.of("missing.xml")));
        Await.until("another notice", () -> notices.size() == 2);
        assertEquals("missing.xml: not found", notices.get(1).text());
        assertSame(before, session.document().scene());
    }

    @Test
    void aFileThatCannotBeWrittenKeepsTheMark() {
        move();
        OnEventThread.run(() -> session.save(Path.of("full", "room.xml")));
        Await.until("a notice", () -> notices.size() == 1);
        assertEquals(
                Path.of("full", "room.xml") + ": no space left", notices.get(0).text());
        assertTrue(session.document().isUnsaved());
        assertEquals(Optional.of(FILE), session.document().file());
    }

    @Test
    void theSelectionForgetsWhatIsDeleted() {
        OnEventThread.run(() -> {
            session.selection().set(List.of("crate", "post"));
            session.document()
                    .commit("Delete", SceneEdits.removed(session.document().scene(), List.of("crate")));
            assertEquals(List.of("post"), session.selection().ids());
        });
    }
}
