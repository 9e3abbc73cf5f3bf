package troupe.app.tool.select;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.document.Mark;
import troupe.app.document.Outlines;
import troupe.app.document.SceneEdits;
import troupe.app.document.Selection;
import troupe.app.tool.Editing;
import troupe.app.tool.Hits;
import troupe.app.tool.Pointer;
import troupe.app.tool.Sketch;
import troupe.app.tool.Snapping;
import troupe.app.tool.Tool;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Element;
import troupe.scene.Scene;

/**
 * Selects and edits: a press selects what lies under the pointer, Shift adds or takes away; dragging moves the
 * selection, or a place of the task ({@link Mark}); dragging over nothing draws a box that selects what it holds.
 * Of what is selected the corners can be dragged; a double click on an edge inserts one; the frame around it
 * scales, and the knob above it turns. Moves snap as {@link Snapping} says.
 */
public final class SelectTool implements Tool {
    private static final double SLACK = 3;

    private final Editing editing;
    private Pointer from;
    private Point to;
    private boolean boxing;
    private boolean moved;
    private Optional<Gesture> gesture = Optional.empty();
    private Optional<Gesture.Outcome> outcome = Optional.empty();
    private String cornerOf = "";
    private int corner = -1;

    /** Makes the tool. */
    public SelectTool(Editing editing) {
        this.editing = editing;
    }

    @Override
    public String key() {
        return "select";
    }

    private Optional<Mark> mark(Pointer pointer) {
        return editing.document()
                .shownTask()
                .flatMap(task -> Hits.mark(task, editing.view().get(), pointer.px(), pointer.py()));
    }

    /** Returns the id of what lies under the pointer: a thing, or where a group of the task stands at first. */
    private Optional<String> thing(Pointer pointer) {
        Scene scene = editing.document().shown();
        return Hits.element(scene, pointer.at(), editing.pixel())
                .map(Element::id)
                .or(() -> editing.document()
                        .shownTask()
                        .flatMap(task -> Hits.spawn(scene, task, pointer.at(), editing.pixel())));
    }

    private Optional<Handles> handles() {
        return Handles.of(
                editing.document().scene(),
                editing.selection().ids(),
                editing.view().get());
    }

    /** Returns the id of what is selected, if that is one thing. */
    private Optional<String> single() {
        List<String> ids = editing.selection().ids();
        return ids.size() == 1 ? Optional.of(ids.get(0)) : Optional.empty();
    }

    private Optional<Polygon> outline(Scene scene, Optional<String> id) {
        return id.flatMap(i -> SceneEdits.outline(scene, i));
    }

    @Override
    public void press(Pointer pointer) {
        from = pointer;
        to = pointer.at();
        boxing = false;
        moved = false;
        outcome = Optional.empty();
        gesture = Optional.empty();
        if (!pointer.shift() && takeHold(pointer)) {
            return;
        }
        corner = -1;
        Optional<Mark> mark = mark(pointer);
        Optional<String> chosen = mark.flatMap(this::among);
        if (mark.isPresent() && chosen.isEmpty() && !pointer.shift()) {
            gesture = Optional.of(new MarkGesture(editing, pointer, mark.get()));
            editing.selection().set(List.of(mark.get().owner()));
            return;
        }
        Optional<String> hit = chosen.or(() -> mark.map(Mark::id)).or(() -> thing(pointer));
        if (hit.isEmpty()) {
            boxing = true;
            if (!pointer.shift()) {
                editing.selection().clear();
            }
            return;
        }
        String id = hit.get();
        if (pointer.shift()) {
            editing.selection().toggle(id);
        } else if (!editing.selection().contains(id)) {
            editing.selection().set(List.of(id));
        }
        if (editing.selection().contains(id)) {
            gesture = Optional.of(new MoveGesture(editing, pointer));
        }
    }

    /** Takes hold of a handle of the selection, or of a new corner on its edge. */
    private boolean takeHold(Pointer pointer) {
        Optional<Handles> handles = handles();
        if (handles.isEmpty()) {
            return false;
        }
        Optional<Handles.Hold> hold = handles.get().find(editing.view().get(), pointer.px(), pointer.py());
        if (hold.isPresent()) {
            Gesture made =
                    switch (hold.get().kind()) {
                        case CORNER ->
                            cornerGesture(new CornerGesture(
                                    editing,
                                    editing.selection().ids().stream()
                                            .filter(id -> SceneEdits.outline(
                                                            editing.document().scene(), id)
                                                    .isPresent())
                                            .findFirst()
                                            .orElseThrow(),
                                    hold.get().index()));
                        case TURN ->
                            new TurnGesture(editing, pointer, handles.get().box());
                        case SCALE ->
                            new ScaleGesture(
                                    editing, pointer, handles.get(), hold.get().index());
                    };
            gesture = Optional.of(made);
            return true;
        }
        Optional<Integer> edge = pointer.clicks() == 2 && single().isPresent()
                ? handles.get().edge(pointer.at(), editing.pixel())
                : Optional.empty();
        edge.ifPresent(i -> {
            CornerGesture made =
                    cornerGesture(CornerGesture.inserting(editing, single().orElseThrow(), i, pointer.at()));
            gesture = Optional.of(made);
            outcome = Optional.of(made.unmoved());
            editing.document().preview(made.unmoved().scene());
        });
        return edge.isPresent();
    }

    /** Returns as what a place is selected together with other things: by itself, or with its owner. */
    private Optional<String> among(Mark mark) {
        Selection selection = editing.selection();
        return Optional.of(selection.contains(mark.id()) ? mark.id() : mark.owner())
                .filter(id -> selection.contains(id) && selection.ids().size() > 1);
    }

    private CornerGesture cornerGesture(CornerGesture made) {
        cornerOf = single().orElse("");
        corner = made.corner();
        return made;
    }

    @Override
    public void drag(Pointer pointer) {
        to = pointer.at();
        if (gesture.isPresent() && from != null) {
            moved |= pointer.pixelsTo(from) > SLACK;
            if (moved) {
                outcome = gesture.map(g -> g.at(pointer));
                editing.document().preview(outcome.orElseThrow().scene());
            }
        }
    }

    @Override
    public void release(Pointer pointer) {
        if (gesture.isPresent() && editing.document().isPreviewing()) {
            Gesture done = gesture.get();
            if (moved) {
                outcome = Optional.of(done.at(pointer));
            }
            gesture = Optional.empty();
            if (moved || done.needsNoMove()) {
                editing.document().commit(done.name(), outcome.orElseThrow().scene());
            } else {
                editing.document().dropPreview();
            }
        } else if (boxing) {
            selectBox(pointer);
        }
        end();
    }

    private void end() {
        gesture = Optional.empty();
        outcome = Optional.empty();
        boxing = false;
        moved = false;
    }

    private void selectBox(Pointer pointer) {
        if (pointer.pixelsTo(from) > SLACK) {
            Scene scene = editing.document().shown();
            List<String> inside = new ArrayList<>(Hits.inside(scene, box()));
            editing.document().shownTask().ifPresent(task -> inside.addAll(Hits.inside(scene, task, box())));
            if (pointer.shift()) {
                inside.stream().filter(id -> !editing.selection().contains(id)).forEach(editing.selection()::toggle);
            } else {
                editing.selection().set(inside);
            }
        }
    }

    private Box box() {
        Point a = from.at();
        return new Box(
                Math.min(a.x(), to.x()), Math.min(a.y(), to.y()), Math.max(a.x(), to.x()), Math.max(a.y(), to.y()));
    }

    @Override
    public void cancel() {
        end();
        corner = -1;
        editing.document().dropPreview();
    }

    /** {@inheritDoc} That part is the corner that was pressed last, while its outline has more than three. */
    @Override
    public boolean delete() {
        Scene scene = editing.document().scene();
        Optional<String> id = single();
        Optional<Polygon> outline = outline(scene, id);
        boolean held = corner >= 0
                && outline.isPresent()
                && id.get().equals(cornerOf)
                && corner < outline.get().size();
        if (held && outline.get().size() > 3) {
            Polygon without = Outlines.withoutCorner(outline.get(), corner);
            corner = -1;
            editing.document()
                    .commit(
                            editing.texts().format("edit.uncorner", SceneEdits.name(scene, id.get())),
                            SceneEdits.reshaped(scene, List.of(id.get()), before -> without));
        }
        return held;
    }

    @Override
    public String message() {
        return outcome.map(o -> o.wrong().orElse(o.text())).orElse("");
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        Optional<Handles.Hold> hold =
                handles().flatMap(h -> h.find(editing.view().get(), pointer.px(), pointer.py()));
        if (hold.isPresent()) {
            int[] frame = {
                Cursor.SW_RESIZE_CURSOR, Cursor.SE_RESIZE_CURSOR, Cursor.NE_RESIZE_CURSOR, Cursor.NW_RESIZE_CURSOR
            };
            return Cursor.getPredefinedCursor(
                    switch (hold.get().kind()) {
                        case CORNER -> Cursor.CROSSHAIR_CURSOR;
                        case TURN -> Cursor.HAND_CURSOR;
                        case SCALE -> frame[hold.get().index()];
                    });
        }
        boolean over = mark(pointer).isPresent() || thing(pointer).isPresent();
        return Cursor.getPredefinedCursor(over ? Cursor.MOVE_CURSOR : Cursor.DEFAULT_CURSOR);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        if (!boxing && outcome.isEmpty()) {
            HandlePainter.paint(g, view, editing.look(), handles(), active());
        }
        outcome.ifPresent(o -> {
            boolean wrong = o.wrong().isPresent();
            if (wrong) {
                outline(o.scene(), single())
                        .ifPresent(outline -> Sketch.outline(g, view, editing.look(), outline, true));
            }
            Sketch.guide(g, view, editing.look(), o.guide(), o.at());
            Sketch.beside(g, editing.look(), view.px(to.x()), view.py(to.y()), message(), wrong);
        });
        if (boxing) {
            paintBox(g, view);
        }
    }

    private int active() {
        return single().orElse("").equals(cornerOf) ? corner : -1;
    }

    private void paintBox(Graphics2D g, Viewport view) {
        Box box = box();
        Rectangle2D shape = new Rectangle2D.Double(
                view.px(box.minX()), view.py(box.maxY()), box.width() * view.scale(), box.depth() * view.scale());
        Color accent = editing.look().color(Tone.ACCENT);
        g.setColor(new Color(accent.getRed(), accent.getGreen(), accent.getBlue(), 30));
        g.fill(shape);
        g.setColor(accent);
        g.setStroke(new BasicStroke(1));
        g.draw(shape);
    }

    @Override
    public Object stamp() {
        return List.of(boxing ? List.of(from.at(), to) : "", outcome.isPresent() ? outcome.get() : "", active());
    }
}
