package troupe.app.document;

import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Holds the scene that is being edited, its revision, the file it belongs to and the task that is
 * looked at. The scene is immutable and replaced as a whole: by {@link #commit}, which makes one named
 * step of the history, or for the time of a gesture by {@link #preview}, which leaves no trace when it
 * is dropped. Belongs to the event thread.
 */
public final class SceneDocument {

    /** What an observer is told about. */
    public enum Change {
        /** Another document was opened. */
        OPENED,
        /** The scene that is shown changed. */
        SCENE,
        /** Another task is looked at. */
        TASK,
        /** The file, or whether there is something to save, changed. */
        FILE
    }

    private final Listeners<Change> listeners = new Listeners<>();
    private final UndoHistory history;
    private Scene scene;
    private Scene preview;
    private Version version = new Version(0, 0);
    private Optional<Path> file;
    private String task;

    /** Makes a document of a scene; {@code file} is where it was read from, if from a file. */
    public SceneDocument(Scene scene, Optional<Path> file) {
        EventThread.require();
        this.history = new UndoHistory(Objects.requireNonNull(scene), this::restore);
        this.scene = scene;
        this.file = file;
        this.task = firstTask(scene);
    }

    private static String firstTask(Scene scene) {
        return scene.tasks().isEmpty() ? "" : scene.tasks().get(0).id();
    }

    /** Returns the observers of this document. */
    public Listeners<Change> listeners() {
        return listeners;
    }

    /** Returns the undo history. */
    public UndoHistory history() {
        return history;
    }

    /** Returns the scene as it was last committed. */
    public Scene scene() {
        return scene;
    }

    /** Returns the scene to show: the preview while a gesture is under way, else the committed one. */
    public Scene shown() {
        return preview == null ? scene : preview;
    }

    /** Tells whether a gesture is under way. */
    public boolean isPreviewing() {
        return preview != null;
    }

    /** Returns the version of what {@link #shown()} returns; it grows with each change. */
    public Version version() {
        return version;
    }

    /** Returns the file that the document is saved to, empty for one that was never saved. */
    public Optional<Path> file() {
        return file;
    }

    /** Tells whether the scene differs from what the file holds. */
    public boolean isUnsaved() {
        return history.isUnsaved();
    }

    /** Returns the id of the task that is looked at, empty if the scene has none. */
    public String task() {
        return task;
    }

    /** Returns the task that is looked at, as it stands in the scene that is shown. */
    public Optional<Task> shownTask() {
        return shown().task(task);
    }

    /** Shows another scene for the time of a gesture; each call replaces the preview before. */
    public void preview(Scene changed) {
        EventThread.require();
        preview = Objects.requireNonNull(changed);
        version = new Version(version.revision(), version.preview() + 1);
        listeners.tell(Change.SCENE);
    }

    /** Ends a gesture without a trace: the committed scene is shown again. */
    public void dropPreview() {
        EventThread.require();
        if (preview != null) {
            preview = null;
            show(scene);
        }
    }

    /**
     * Replaces the scene as one step of the history, and ends the preview. A scene equal to the
     * committed one makes no step.
     *
     * @param name what the step does, in the language of the person: {@code Move Crate}
     */
    public void commit(String name, Scene changed) {
        EventThread.require();
        if (changed.equals(scene)) {
            dropPreview();
            return;
        }
        Scene before = scene;
        preview = null;
        history.add(name, before, changed);
        show(changed);
        listeners.tell(Change.FILE);
    }

    /** Opens another scene in place of this one; the history begins anew. */
    public void open(Scene opened, Optional<Path> from) {
        EventThread.require();
        preview = null;
        file = from;
        task = firstTask(opened);
        history.begin(opened);
        version = new Version(version.revision() + 1, 0);
        scene = opened;
        listeners.tell(Change.OPENED);
        listeners.tell(Change.FILE);
    }

    /** Notes that {@code written} is now what the file holds; the scene may have changed since. */
    public void savedAs(Path to, Scene written) {
        EventThread.require();
        file = Optional.of(to);
        history.markSaved(written);
        listeners.tell(Change.FILE);
    }

    /**
     * Looks at another task.
     *
     * @throws IllegalArgumentException if the scene has no such task
     */
    public void lookAt(String id) {
        EventThread.require();
        if (scene.task(id).isEmpty()) {
            throw new IllegalArgumentException("no task '" + id + "' in the scene");
        }
        if (!id.equals(task)) {
            task = id;
            version = new Version(version.revision() + 1, 0);
            listeners.tell(Change.TASK);
        }
    }

    private void restore(Scene earlier) {
        preview = null;
        show(earlier);
        listeners.tell(Change.FILE);
    }

    private void show(Scene changed) {
        scene = changed;
        version = new Version(version.revision() + 1, 0);
        if (scene.task(task).isEmpty()) {
            task = firstTask(scene);
        }
        listeners.tell(Change.SCENE);
    }
}
