package troupe.app.canvas;

import java.awt.Cursor;
import troupe.app.document.SceneEdits;
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
        Place place = Place.of(
                Math.rint(pointer.at().x() * 100) / 100, Math.rint(pointer.at().y() * 100) / 100);
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
