package troupe.app.tool.draw;

import java.awt.Cursor;
import java.util.List;
import java.util.Optional;
import troupe.app.document.CrowdEdits;
import troupe.app.document.Parts;
import troupe.app.document.SceneEdits;
import troupe.app.tool.Editing;
import troupe.app.tool.Hits;
import troupe.app.tool.Pointer;
import troupe.app.tool.Snapping;
import troupe.app.tool.Tool;
import troupe.geometry.Point;
import troupe.scene.Crowd;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Puts the start or the goal of the journey or the encounter, or the goals of the crowd, where the pointer is. */
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
        String task = editing.document().task();
        if (scene.task(task).orElse(null) instanceof Crowd crowd) {
            return end == Hits.End.START ? scene : goal(scene, crowd, place);
        }
        return end == Hits.End.START
                ? SceneEdits.startingAt(scene, task, place)
                : SceneEdits.endingAt(scene, task, place);
    }

    /** Puts the goal of the groups of a crowd that are selected, or else of all that have one. */
    private Scene goal(Scene scene, Crowd crowd, Place place) {
        List<String> selected = editing.selection().ids().stream()
                .filter(id -> Parts.group(scene, id).isPresent())
                .toList();
        List<String> all = crowd.allGroups()
                .filter(g -> g.goal().isPresent())
                .map(g -> Parts.id(crowd.id(), g.id()))
                .toList();
        Scene changed = scene;
        for (String id : selected.isEmpty() ? all : selected) {
            changed = Parts.withGroup(changed, id, g -> CrowdEdits.going(g, Optional.of(place)));
        }
        return changed;
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
