package troupe.app.tool;

import java.util.Optional;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.geometry.Point;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Moves the start or the goal of the journey that is looked at. */
final class EndGesture implements Gesture {
    private final Editing editing;
    private final Pointer from;
    private final Hits.End end;
    private final Scene scene;
    private final Journey journey;

    EndGesture(Editing editing, Pointer from, Hits.End end) {
        this.editing = editing;
        this.from = from;
        this.end = end;
        this.scene = editing.document().scene();
        this.journey = (Journey) scene.task(editing.document().task()).orElseThrow();
    }

    private Place place() {
        return end == Hits.End.START ? journey.start() : journey.goal();
    }

    @Override
    public Outcome at(Pointer pointer) {
        Place before = place();
        Point wanted = new Point(
                before.x() + pointer.at().x() - from.at().x(),
                before.y() + pointer.at().y() - from.at().y());
        Snapping snapping =
                new Snapping(scene, java.util.List.of(), editing.view().get().scale());
        Point anchor = new Point(before.x(), before.y());
        Snap snap = pointer.alt() || pointer.shift()
                ? snapping.place(wanted, Optional.of(anchor), pointer.shift(), pointer.alt())
                : snapping.onGrid(wanted);
        Place place = new Place(snap.at().x(), snap.at().y(), before.z());
        Scene moved = end == Hits.End.START
                ? SceneEdits.startingAt(scene, journey, place)
                : SceneEdits.endingAt(scene, journey, place);
        String text = Texts.number(place.x(), 2) + ", " + Texts.number(place.y(), 2) + " m";
        return new Outcome(moved, snap.at(), snap.guide(), text, Optional.empty());
    }

    @Override
    public String name() {
        return editing.texts().get(end == Hits.End.START ? "edit.start" : "edit.goal");
    }
}
