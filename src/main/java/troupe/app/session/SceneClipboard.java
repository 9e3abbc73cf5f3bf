package troupe.app.session;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Supplier;
import troupe.app.document.EventThread;
import troupe.app.document.Pasting;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/**
 * Cuts, copies and pastes parts of scenes through the clipboard of the system, as texts of the scene format, so
 * that they can go to another window or into an editor. Writes and reads in the background. Belongs to the event
 * thread.
 */
public final class SceneClipboard implements AutoCloseable {
    private final Session session;
    private final Supplier<Clipboard> clipboard;
    private final SceneText text;
    private final Texts texts;
    private final Executor eventThread;
    private final ExecutorService background = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "clipboard");
        thread.setDaemon(true);
        return thread;
    });

    /** Makes the clipboard of a session. */
    public SceneClipboard(
            Session session, Supplier<Clipboard> clipboard, SceneText text, Texts texts, Executor eventThread) {
        this.session = session;
        this.clipboard = clipboard;
        this.text = text;
        this.texts = texts;
        this.eventThread = eventThread;
    }

    private SceneDocument document() {
        return session.document();
    }

    private List<String> selected() {
        return session.selection().ids();
    }

    /** Copies what is selected; nothing if nothing is. */
    public void copy() {
        EventThread.require();
        if (selected().isEmpty()) {
            return;
        }
        Scene part = Pasting.extract(document().scene(), selected());
        background.execute(() -> {
            String written = text.write(part);
            try {
                clipboard.get().setContents(new StringSelection(written), null);
            } catch (IllegalStateException e) {
                tell(texts.get("paste.busy"));
            }
        });
    }

    /** Copies what is selected and takes it out of the scene. */
    public void cut() {
        copy();
        List<String> ids = selected();
        document().commit(name("edit.cut", ids), SceneEdits.removed(document().scene(), ids));
    }

    /** Puts what the clipboard holds into the scene as one step, and selects it; a notice says why if it cannot. */
    public void paste() {
        EventThread.require();
        background.execute(() -> {
            try {
                Object held = clipboard.get().getData(DataFlavor.stringFlavor);
                Scene read = text.read(String.valueOf(held));
                eventThread.execute(() -> put(read, "edit.paste"));
            } catch (SceneException | UnsupportedFlavorException | IOException e) {
                tell(texts.get("paste.none"));
            } catch (IllegalStateException e) {
                tell(texts.get("paste.busy"));
            }
        });
    }

    /** Puts a copy of what is selected beside it, and selects the copy. */
    public void duplicate() {
        EventThread.require();
        put(Pasting.extract(document().scene(), selected()), "edit.duplicate");
    }

    private void put(Scene part, String key) {
        Pasting.Pasted pasted =
                Pasting.into(document().scene(), part, document().task());
        if (!pasted.ids().isEmpty()) {
            String name = pasted.ids().size() == 1
                    ? texts.format(
                            key, SceneEdits.name(pasted.scene(), pasted.ids().get(0)))
                    : texts.format(key + ".several", pasted.ids().size());
            document().commit(name, pasted.scene());
            session.selection().set(pasted.ids());
        } else if (part.elements().findAny().isPresent()) {
            session.notices().tell(new Notice(true, texts.get("paste.nowhere")));
        }
    }

    private String name(String key, List<String> ids) {
        return ids.size() == 1
                ? texts.format(key, SceneEdits.name(document().scene(), ids.get(0)))
                : texts.format(key + ".several", ids.size());
    }

    private void tell(String what) {
        eventThread.execute(() -> session.notices().tell(new Notice(true, what)));
    }

    @Override
    public void close() {
        background.shutdown();
    }
}
