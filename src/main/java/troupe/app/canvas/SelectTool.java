package troupe.app.canvas;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import troupe.app.document.SceneEdits;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.paint.Viewport;
import troupe.scene.Element;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Selects and moves: a press selects what lies under the pointer, Shift adds or takes away; dragging
 * moves the selection, or the start or the goal of the task; dragging over nothing draws a box that
 * selects what it holds. While a thing is moved Shift keeps it on multiples of 45 degrees. Moves are in
 * whole centimetres, finer with Alt.
 */
public final class SelectTool implements Tool {
    private static final double SLACK = 3;
    private static final double STEP = 0.01;

    /** What the gesture under way does. */
    private enum Gesture {
        NONE,
        PRESSED,
        MOVING,
        BOXING,
        START,
        GOAL
    }

    private final Editing editing;
    private final Color accent;
    private Gesture gesture = Gesture.NONE;
    private Pointer from;
    private Point to;

    /** Makes the tool; {@code accent} is the colour of its box. */
    public SelectTool(Editing editing, Color accent) {
        this.editing = editing;
        this.accent = accent;
    }

    @Override
    public String key() {
        return "select";
    }

    private Optional<Journey> journey() {
        return editing.document().shownTask().map(task -> task instanceof Journey j ? j : null);
    }

    private Optional<Hits.End> end(Pointer pointer) {
        return journey().flatMap(j -> Hits.end(j, editing.view().get(), pointer.px(), pointer.py()));
    }

    private Optional<Element> element(Pointer pointer) {
        return Hits.element(
                editing.document().shown(),
                pointer.at(),
                1 / editing.view().get().scale());
    }

    @Override
    public void press(Pointer pointer) {
        from = pointer;
        to = pointer.at();
        Optional<Hits.End> end = end(pointer);
        if (end.isPresent()) {
            gesture = end.get() == Hits.End.START ? Gesture.START : Gesture.GOAL;
            editing.selection().set(List.of(editing.document().task()));
            return;
        }
        Optional<Element> hit = element(pointer);
        if (hit.isEmpty()) {
            gesture = Gesture.BOXING;
            if (!pointer.shift()) {
                editing.selection().clear();
            }
            return;
        }
        String id = hit.get().id();
        if (pointer.shift()) {
            editing.selection().toggle(id);
        } else if (!editing.selection().contains(id)) {
            editing.selection().set(List.of(id));
        }
        gesture = editing.selection().contains(id) ? Gesture.PRESSED : Gesture.NONE;
    }

    @Override
    public void drag(Pointer pointer) {
        to = pointer.at();
        if (gesture == Gesture.PRESSED && Math.hypot(pointer.px() - from.px(), pointer.py() - from.py()) > SLACK) {
            gesture = Gesture.MOVING;
        }
        if (gesture == Gesture.MOVING || gesture == Gesture.START || gesture == Gesture.GOAL) {
            editing.document().preview(moved(pointer));
        }
    }

    private Scene moved(Pointer pointer) {
        Scene scene = editing.document().scene();
        Point by = displacement(pointer);
        if (gesture == Gesture.MOVING) {
            return SceneEdits.shifted(scene, editing.selection().ids(), by.x(), by.y());
        }
        Journey journey = (Journey) scene.task(editing.document().task()).orElseThrow();
        return gesture == Gesture.START
                ? SceneEdits.startingAt(scene, journey, shifted(journey.start(), by))
                : SceneEdits.endingAt(scene, journey, shifted(journey.goal(), by));
    }

    private static Place shifted(Place place, Point by) {
        return new Place(SceneEdits.rounded(place.x() + by.x()), SceneEdits.rounded(place.y() + by.y()), place.z());
    }

    private Point displacement(Pointer pointer) {
        double dx = pointer.at().x() - from.at().x();
        double dy = pointer.at().y() - from.at().y();
        if (pointer.shift()) {
            double eighth = Math.PI / 4;
            double angle = Math.rint(Math.atan2(dy, dx) / eighth) * eighth;
            double along = dx * Math.cos(angle) + dy * Math.sin(angle);
            dx = along * Math.cos(angle);
            dy = along * Math.sin(angle);
        }
        double step = pointer.alt() ? STEP / 100 : STEP;
        return new Point(Math.rint(dx / step) * step, Math.rint(dy / step) * step);
    }

    @Override
    public void release(Pointer pointer) {
        switch (gesture) {
            case MOVING, START, GOAL -> {
                if (editing.document().isPreviewing()) {
                    Scene moved = moved(pointer);
                    String name = name();
                    gesture = Gesture.NONE;
                    editing.document().commit(name, rounded(moved));
                }
            }
            case BOXING -> selectBox(pointer);
            default -> {
                // a press without a move has selected already
            }
        }
        gesture = Gesture.NONE;
    }

    /** Rounds the corners of what was moved, so that a sum of decimals is written as a person would. */
    private Scene rounded(Scene scene) {
        Scene changed = scene;
        for (String id : editing.selection().ids()) {
            Optional<Element> element = scene.element(id);
            if (element.isPresent()) {
                changed = changed.with(SceneEdits.tidied(element.get()));
            }
        }
        return changed;
    }

    private String name() {
        if (gesture == Gesture.START || gesture == Gesture.GOAL) {
            return editing.texts().get(gesture == Gesture.START ? "edit.start" : "edit.goal");
        }
        List<String> ids = editing.selection().ids();
        return ids.size() == 1
                ? editing.texts()
                        .format("edit.move", SceneEdits.name(editing.document().scene(), ids.get(0)))
                : editing.texts().format("edit.move.several", ids.size());
    }

    private void selectBox(Pointer pointer) {
        if (Math.hypot(pointer.px() - from.px(), pointer.py() - from.py()) > SLACK) {
            List<String> inside = Hits.inside(editing.document().shown(), box());
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
        gesture = Gesture.NONE;
        editing.document().dropPreview();
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        boolean over = end(pointer).isPresent() || element(pointer).isPresent();
        return Cursor.getPredefinedCursor(over ? Cursor.MOVE_CURSOR : Cursor.DEFAULT_CURSOR);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        if (gesture == Gesture.BOXING) {
            Box box = box();
            Rectangle2D shape = new Rectangle2D.Double(
                    view.px(box.minX()), view.py(box.maxY()), box.width() * view.scale(), box.depth() * view.scale());
            g.setColor(new Color(accent.getRed(), accent.getGreen(), accent.getBlue(), 30));
            g.fill(shape);
            g.setColor(accent);
            g.setStroke(new BasicStroke(1));
            g.draw(shape);
        }
    }

    @Override
    public Object stamp() {
        return gesture == Gesture.BOXING ? List.of(from.at(), to) : "";
    }
}
