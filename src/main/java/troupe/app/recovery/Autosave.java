package troupe.app.recovery;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javax.swing.Timer;
import troupe.app.document.EventThread;
import troupe.app.document.SceneDocument;
import troupe.app.session.SceneFiles;
import troupe.scene.Scene;

/**
 * Keeps the edits of a document in a file beside its own, at most a few seconds old, for as long as they are not
 * saved. What is drawn or dragged at the moment is not among them, the edits before are. Belongs to the event
 * thread; writes on a thread of its own, which the program waits for when it ends.
 */
public final class Autosave implements AutoCloseable {
    /** How old an edit gets at most before it is kept, in milliseconds. */
    public static final int PERIOD_MS = 2_000;

    private final SceneDocument document;
    private final SceneFiles files;
    private final KeptFiles kept;
    private final Consumer<IOException> failed;
    private final Timer timer;
    private final ExecutorService background = Executors.newSingleThreadExecutor(task -> new Thread(task, "recovery"));
    private final Runnable leave;
    private Optional<Path> belongs;
    private Optional<Path> slot = Optional.empty();

    /** Keeps a document's edits from now on; {@code failed} is told, on the background thread, what cannot be kept. */
    public Autosave(SceneDocument document, SceneFiles files, KeptFiles kept, Consumer<IOException> failed) {
        EventThread.require();
        this.document = document;
        this.files = files;
        this.kept = kept;
        this.failed = failed;
        this.belongs = document.file();
        this.timer = new Timer(PERIOD_MS, e -> keep());
        timer.setRepeats(false);
        this.leave = document.listeners().add(this::changed);
    }

    private void changed(SceneDocument.Change change) {
        if (change == SceneDocument.Change.OPENED || !belongs.equals(document.file()) || !document.isUnsaved()) {
            timer.stop();
            forget();
            belongs = document.file();
        }
        if (document.isUnsaved() && !timer.isRunning()) {
            timer.start();
        }
    }

    /** Keeps the edits at once, if there are any. */
    public void keep() {
        EventThread.require();
        if (!document.isUnsaved()) {
            return;
        }
        Path to = kept.slot(belongs);
        slot = Optional.of(to);
        Scene scene = document.scene();
        background.execute(() -> write(scene, to));
    }

    private void write(Scene scene, Path to) {
        try {
            Files.createDirectories(to.toAbsolutePath().getParent());
            files.write(scene, to);
        } catch (IOException e) {
            failed.accept(e);
        }
    }

    private void forget() {
        slot.ifPresent(this::remove);
        slot = Optional.empty();
    }

    /** Removes a file of edits that is not needed any more, after what is being written. */
    public void remove(Path file) {
        background.execute(() -> {
            try {
                Files.deleteIfExists(file);
            } catch (IOException e) {
                failed.accept(e);
            }
        });
    }

    /** Runs something on the thread that writes, after what is being written. */
    public void inBackground(Runnable task) {
        background.execute(task);
    }

    /** Ends, as the document is given up on purpose: nothing is kept of it. */
    @Override
    public void close() {
        leave.run();
        timer.stop();
        forget();
        background.shutdown();
    }
}
