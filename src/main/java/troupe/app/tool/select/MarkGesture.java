package troupe.app.tool.select;

import java.util.List;
import java.util.Optional;
import troupe.app.document.Mark;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.app.tool.Editing;
import troupe.app.tool.Pointer;
import troupe.app.tool.Snap;
import troupe.app.tool.Snapping;
import troupe.geometry.Point;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Moves a place of the task that is looked at. */
public final class MarkGesture implements Gesture {
    private final Editing editing;
    private final Pointer from;
    private final Mark mark;
    private final Scene scene;

    /** Begins to move a place from where the pointer went down. */
    public MarkGesture(Editing editing, Pointer from, Mark mark) {
        this.editing = editing;
        this.from = from;
        this.mark = mark;
        this.scene = editing.document().scene();
    }

    @Override
    public Outcome at(Pointer pointer) {
        Place before = mark.place();
        Point wanted = new Point(
                before.x() + pointer.at().x() - from.at().x(),
                before.y() + pointer.at().y() - from.at().y());
        Snapping snapping = new Snapping(scene, List.of(), editing.view().get().scale());
        Point anchor = new Point(before.x(), before.y());
        Snap snap = pointer.alt() || pointer.shift()
                ? snapping.place(wanted, Optional.of(anchor), pointer.shift(), pointer.alt())
                : snapping.onGrid(wanted);
        Place place = new Place(snap.at().x(), snap.at().y(), before.z());
        String text = Texts.number(place.x(), 2) + ", " + Texts.number(place.y(), 2) + " m";
        return new Outcome(mark.moved(scene, place), snap.at(), snap.guide(), text, Optional.empty());
    }

    @Override
    public String name() {
        String owner = SceneEdits.name(scene, mark.owner());
        return switch (mark.kind()) {
            case START -> editing.texts().get("edit.start");
            case GOAL -> editing.texts().get("edit.goal");
            case AVATAR -> editing.texts().format("edit.move", owner);
            case HEAD -> editing.texts().format("edit.head", owner);
            case GROUP -> editing.texts().format("edit.goalof", owner);
        };
    }
}
