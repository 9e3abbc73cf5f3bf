package troupe.app.document;

import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.undo.AbstractUndoableEdit;
import javax.swing.undo.UndoManager;
import javax.swing.undo.UndoableEdit;
import troupe.scene.Scene;

/**
 * Holds the named steps that led to the present scene, and those that were taken back. A step holds
 * the scenes before and after it; as scenes share what they have in common, a step costs little more
 * than what it changed. Belongs to the event thread.
 */
public final class UndoHistory extends UndoManager {
    /** The most steps that are kept; the oldest is forgotten first. */
    public static final int STEPS = 2_000;

    private final transient Consumer<Scene> show;
    private final transient Listeners<UndoHistory> listeners = new Listeners<>();
    private final Action undoAction = action(this::stepBack);
    private final Action redoAction = action(this::stepForward);
    private transient Scene saved;
    private transient Scene present;
    private boolean jumping;

    /** Makes the empty history of a scene; {@code show} is given the scene to go back or forward to. */
    UndoHistory(Scene scene, Consumer<Scene> show) {
        this.show = show;
        this.saved = scene;
        this.present = scene;
        setLimit(STEPS);
        tell();
    }

    private static Action action(Runnable step) {
        return new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                step.run();
            }
        };
    }

    /** Returns the action that takes a step back; its long description is the name of that step. */
    public Action undoAction() {
        return undoAction;
    }

    /** Returns the action that does a step again; its long description is the name of that step. */
    public Action redoAction() {
        return redoAction;
    }

    /** Tells whether the present scene differs from the one that was saved last. */
    public boolean isUnsaved() {
        return present != saved && !present.equals(saved);
    }

    /** Notes that {@code written} is what the file holds now. */
    void markSaved(Scene written) {
        saved = written;
    }

    private void tell() {
        undoAction.setEnabled(canUndo());
        undoAction.putValue(Action.LONG_DESCRIPTION, undoName());
        redoAction.setEnabled(canRedo());
        redoAction.putValue(Action.LONG_DESCRIPTION, redoName());
        listeners.tell(this);
    }

    private void go(Scene scene) {
        present = scene;
        if (!jumping) {
            show.accept(scene);
        }
    }

    /** Returns the observers, told after each change of the history. */
    public Listeners<UndoHistory> listeners() {
        return listeners;
    }

    /** Adds a step that has just been done. */
    void add(String name, Scene before, Scene after) {
        addEdit(new Step(name, before, after));
        present = after;
        tell();
    }

    /** Forgets every step, and begins anew with a scene that is saved. */
    void begin(Scene scene) {
        discardAllEdits();
        saved = scene;
        present = scene;
        tell();
    }

    /** Takes the last step back, if there is one. */
    public void stepBack() {
        EventThread.require();
        if (canUndo()) {
            undo();
            tell();
        }
    }

    /** Does the step that was last taken back again, if there is one. */
    public void stepForward() {
        EventThread.require();
        if (canRedo()) {
            redo();
            tell();
        }
    }

    /** Returns the name of the step that {@link #stepBack} would take back, empty if there is none. */
    public String undoName() {
        return name(editToBeUndone());
    }

    /** Returns the name of the step that {@link #stepForward} would do again, empty if there is none. */
    public String redoName() {
        return name(editToBeRedone());
    }

    private static String name(UndoableEdit edit) {
        return edit == null ? "" : edit.getPresentationName();
    }

    /** Returns the names of all steps, the oldest first, those that were taken back among them. */
    public List<String> names() {
        List<String> names = new ArrayList<>();
        for (UndoableEdit edit : edits) {
            names.add(edit.getPresentationName());
        }
        return names;
    }

    /** Returns how many of {@link #names()} are done. */
    public int position() {
        UndoableEdit next = editToBeRedone();
        return next == null ? edits.size() : edits.indexOf(next);
    }

    /** Goes back or forward at one go until {@code done} steps are done, {@code 0 <= done <= names().size()}. */
    public void jump(int done) {
        EventThread.require();
        Scene before = present;
        jumping = true;
        int at = position();
        for (; at > done && canUndo(); at--) {
            undo();
        }
        for (; at < done && canRedo(); at++) {
            redo();
        }
        jumping = false;
        if (present != before) {
            show.accept(present);
        }
        tell();
    }

    /** One step: the scenes before and after it. */
    private final class Step extends AbstractUndoableEdit {
        private final String name;
        private final transient Scene before;
        private final transient Scene after;

        private Step(String name, Scene before, Scene after) {
            this.name = name;
            this.before = before;
            this.after = after;
        }

        @Override
        public String getPresentationName() {
            return name;
        }

        @Override
        public void undo() {
            super.undo();
            go(before);
        }

        @Override
        public void redo() {
            super.redo();
            go(after);
        }
    }
}
