package troupe.app.tool.select;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.document.Mark;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.app.tool.Editing;
import troupe.app.tool.Guide;
import troupe.app.tool.Pointer;
import troupe.app.tool.Snap;
import troupe.app.tool.Snapping;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Moves what is selected. */
final class MoveGesture implements Gesture {
    private static final int MOST_CORNERS = 200;

    private final Editing editing;
    private final Pointer from;
    private final Scene scene;
    private final List<String> ids;
    private final List<Point> corners = new ArrayList<>();

    MoveGesture(Editing editing, Pointer from) {
        this.editing = editing;
        this.from = from;
        this.scene = editing.document().scene();
        this.ids = editing.selection().ids();
        Handles.of(scene, ids, editing.view().get()).map(Handles::box).ifPresent(box -> corners.add(first(box)));
        for (String id : ids) {
            SceneEdits.outline(scene, id).ifPresent(this::addCorners);
            place(id).ifPresent(place -> corners.add(new Point(place.x(), place.y())));
        }
        if (corners.isEmpty()) {
            corners.add(from.at());
        }
    }

    /** Returns the place of a task that an id names, or where the task or the avatar of that id starts. */
    private Optional<Place> place(String id) {
        return scene.tasks().stream()
                .flatMap(task -> Mark.of(task).stream())
                .filter(mark -> mark.id().equals(id)
                        || mark.kind() == Mark.Kind.START && mark.owner().equals(id))
                .map(Mark::place)
                .findFirst();
    }

    private static Point first(Box box) {
        return new Point(box.minX(), box.minY());
    }

    private void addCorners(Polygon outline) {
        for (int i = 0; i < outline.size() && corners.size() < MOST_CORNERS; i++) {
            corners.add(new Point(outline.x(i), outline.y(i)));
        }
    }

    @Override
    public Outcome at(Pointer pointer) {
        Point wanted = new Point(
                pointer.at().x() - from.at().x(), pointer.at().y() - from.at().y());
        Snap snap = new Snapping(scene, ids, editing.view().get().scale())
                .move(corners, wanted, pointer.shift(), pointer.alt());
        Scene moved = SceneEdits.shifted(scene, ids, snap.at().x(), snap.at().y());
        for (String id : ids) {
            moved = moved.element(id).map(SceneEdits::tidied).map(moved::with).orElse(moved);
        }
        Point shown = snap.guide().map(Guide::to).orElse(pointer.at());
        if (snap.guide().filter(g -> g.kind() == Guide.Kind.EDGE).isPresent()) {
            shown = pointer.at();
        }
        String text =
                Texts.number(snap.at().x(), 2) + ", " + Texts.number(snap.at().y(), 2) + " m";
        return new Outcome(moved, shown, snap.guide(), text, Optional.empty());
    }

    @Override
    public String name() {
        return ids.size() == 1
                ? editing.texts().format("edit.move", SceneEdits.name(scene, ids.get(0)))
                : editing.texts().format("edit.move.several", ids.size());
    }
}
