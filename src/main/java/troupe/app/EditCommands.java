package troupe.app;

import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;
import troupe.app.canvas.Canvas;
import troupe.app.command.Commands;
import troupe.app.document.Parts;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.session.SceneClipboard;
import troupe.app.session.Session;
import troupe.app.tool.Hits;
import troupe.app.tool.Tool;
import troupe.scene.Crowd;
import troupe.scene.Element;
import troupe.scene.Scene;

/**
 * Adds the commands that change the scene without the pointer: undo and redo, which take back corners while
 * something is drawn, select, delete and nudge.
 */
final class EditCommands implements AutoCloseable {
    private static final double NUDGE = 0.05;
    private static final double FAR = 0.5;
    private static final double NEAR = 0.01;

    private final Session session;
    private final SceneDocument document;
    private final Look look;
    private final Canvas canvas;
    private final Action undo = action(this::undo);
    private final SceneClipboard clipboard;
    private final List<Runnable> leave = new ArrayList<>();

    EditCommands(Session session, Look look, Canvas canvas) {
        this.session = session;
        this.document = session.document();
        this.look = look;
        this.canvas = canvas;
        this.clipboard = new SceneClipboard(
                session,
                () -> Toolkit.getDefaultToolkit().getSystemClipboard(),
                Studio.TEXT,
                look.texts(),
                EventQueue::invokeLater);
        leave.add(clipboard::close);
        leave.add(document.history().listeners().add(history -> followUndo()));
        leave.add(canvas.gestures().add(tool -> followUndo()));
        followUndo();
    }

    private static Action action(Runnable step) {
        return new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                step.run();
            }
        };
    }

    private boolean isDrawing() {
        Tool tool = canvas.tool();
        return tool != null && tool.isDrawing();
    }

    private void undo() {
        if (isDrawing()) {
            canvas.tool().stepBack();
            canvas.gestures().tell(canvas.tool());
            canvas.repaint();
        } else {
            document.history().stepBack();
        }
    }

    private void followUndo() {
        undo.setEnabled(isDrawing() || document.history().canUndo());
        undo.putValue(
                Action.LONG_DESCRIPTION,
                isDrawing() ? look.text("draw.last") : document.history().undoName());
    }

    /** Adds undo and redo. */
    void addHistory(Commands commands) {
        commands.add("edit", "undo", undo);
        commands.add("edit", "redo", document.history().redoAction());
        commands.separate();
    }

    /** Adds cut, copy, paste and duplicate. */
    void addClipboard(Commands commands) {
        commands.add("edit", "cut", clipboard::cut);
        commands.add("edit", "copy", clipboard::copy);
        commands.add("edit", "paste", clipboard::paste);
        commands.add("edit", "duplicate", clipboard::duplicate);
        commands.separate();
    }

    /** Adds select and delete, and the keys that nudge. */
    void addSelection(Commands commands) {
        commands.add("edit", "selectall", this::selectAll);
        commands.add("edit", "delete", this::delete);
        commands.separate();
        nudgeBy("LEFT", -1, 0);
        nudgeBy("RIGHT", 1, 0);
        nudgeBy("UP", 0, 1);
        nudgeBy("DOWN", 0, -1);
    }

    private void selectAll() {
        List<String> all = new ArrayList<>(document.shown()
                .elements()
                .filter(e -> Hits.outline(e).isPresent())
                .map(Element::id)
                .toList());
        document.shownTask().ifPresent(task -> {
            Parts.of(task).forEach(all::add);
            if (!(task instanceof Crowd)) {
                all.add(task.id());
            }
        });
        session.selection().set(all);
    }

    private void delete() {
        if (canvas.tool() != null && canvas.tool().delete()) {
            return;
        }
        List<String> ids = session.selection().ids();
        Scene without = SceneEdits.removed(document.scene(), ids);
        document.commit(named("edit.delete", ids), without);
    }

    /** Returns the name of an edit of these elements: of the one by its name, of several by their number. */
    private String named(String key, List<String> ids) {
        return ids.size() == 1
                ? look.texts().format(key, SceneEdits.name(document.scene(), ids.get(0)))
                : look.texts().format(key + ".several", ids.size());
    }

    private void nudgeBy(String key, int right, int up) {
        for (String modifier : List.of("", "shift ", "alt ")) {
            String stroke = modifier + key;
            double step = modifier.isEmpty() ? NUDGE : modifier.startsWith("s") ? FAR : NEAR;
            canvas.getInputMap().put(KeyStroke.getKeyStroke(stroke), "nudge." + stroke);
            canvas.getActionMap().put("nudge." + stroke, action(() -> nudge(right * step, up * step)));
        }
    }

    private void nudge(double dx, double dy) {
        List<String> ids = session.selection().ids();
        Scene moved = SceneEdits.shifted(document.scene(), ids, dx, dy);
        for (String id : ids) {
            moved = moved.element(id).map(SceneEdits::tidied).map(moved::with).orElse(moved);
        }
        document.commit(named("edit.move", ids), moved);
    }

    @Override
    public void close() {
        leave.forEach(Runnable::run);
    }
}
