package troupe.app.tool;

import java.awt.Cursor;
import java.util.List;
import java.util.Optional;
import troupe.app.document.SceneEdits;
import troupe.geometry.Point;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Puts the start or the goal of the journey where the pointer is. */
public final class PlaceTool implements Tool {
    private final Editing editing;
    private final Hits.End end;

    /** Makes the tool for one end of the journey. */
    public PlaceTool(Editing editing, Hits.End end) {
        this.editing = editing;
        this.end = end;
    }

    @Override
    public String key() {
        return end == Hits.End.START ? "start" : "goal";
    }

    private Scene placed(Pointer pointer) {
        Scene scene = editing.document().scene();
        Snapping snapping = new Snapping(scene, List.of(), editing.view().get().scale());
        Point at = pointer.alt()
                ? snapping.place(pointer.at(), Optional.empty(), false, true).at()
                : snapping.onGrid(pointer.at()).at();
        Place place = Place.of(at.x(), at.y());
        return scene.task(editing.document().task()).orElse(null) instanceof Journey journey
                ? end == Hits.End.START
                        ? SceneEdits.startingAt(scene, journey, place)
                        : SceneEdits.endingAt(scene, journey, place)
                : scene;
    }

    @Override
    public void press(Pointer pointer) {
        editing.document().preview(placed(pointer));
    }

    @Override
    public void drag(Pointer pointer) {
        editing.document().preview(placed(pointer));
    }

    @Override
    public void release(Pointer pointer) {
        if (editing.document().isPreviewing()) {
            editing.document().commit(editing.texts().get("edit." + key()), placed(pointer));
        }
    }

    @Override
    public void cancel() {
        editing.document().dropPreview();
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
    }
}
