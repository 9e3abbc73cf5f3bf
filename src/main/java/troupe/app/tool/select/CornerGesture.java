package troupe.app.tool.select;

import java.util.List;
import java.util.Optional;
import troupe.app.document.Outlines;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.app.tool.Editing;
import troupe.app.tool.Guide;
import troupe.app.tool.Pointer;
import troupe.app.tool.ShapeCheck;
import troupe.app.tool.Snap;
import troupe.app.tool.Snapping;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Scene;

/** Moves one corner of an outline, which may be a new one on an edge. */
final class CornerGesture implements Gesture {
    private final Editing editing;
    private final Scene scene;
    private final String id;
    private final Polygon outline;
    private final int corner;
    private final boolean inserted;

    /** Makes the gesture of a corner that there is. */
    CornerGesture(Editing editing, String id, int corner) {
        this(editing, id, SceneEdits.outline(editing.document().scene(), id).orElseThrow(), corner, false);
    }

    private CornerGesture(Editing editing, String id, Polygon outline, int corner, boolean inserted) {
        this.editing = editing;
        this.scene = editing.document().scene();
        this.id = id;
        this.outline = outline;
        this.corner = corner;
        this.inserted = inserted;
    }

    /** Makes the gesture that inserts a corner on the edge after corner {@code edge}. */
    static CornerGesture inserting(Editing editing, String id, int edge, Point at) {
        Polygon outline = SceneEdits.outline(editing.document().scene(), id).orElseThrow();
        Point rounded = new Point(SceneEdits.rounded(at.x()), SceneEdits.rounded(at.y()));
        Polygon with = Outlines.withCornerAfter(outline, edge, rounded);
        return new CornerGesture(editing, id, with, edge + 1, true);
    }

    /** Returns the number of the corner. */
    int corner() {
        return corner;
    }

    @Override
    public Outcome at(Pointer pointer) {
        Point anchor = new Point(outline.x(corner), outline.y(corner));
        Snap snap = new Snapping(scene, List.of(id), editing.view().get().scale())
                .place(pointer.at(), Optional.of(anchor), pointer.shift(), pointer.alt());
        return outcome(Outlines.withCorner(outline, corner, snap.at()), snap.at(), snap.guide());
    }

    /** Returns what comes of it when the pointer does not move. */
    Outcome unmoved() {
        return outcome(outline, new Point(outline.x(corner), outline.y(corner)), Optional.empty());
    }

    private Outcome outcome(Polygon changed, Point at, Optional<Guide> guide) {
        Scene bent = SceneEdits.reshaped(scene, List.of(id), outline -> changed);
        String text = Texts.number(at.x(), 2) + ", " + Texts.number(at.y(), 2) + " m";
        return new Outcome(bent, at, guide, text, ShapeCheck.wrong(changed, scene.world(), editing.texts()));
    }

    @Override
    public String name() {
        return editing.texts().format(inserted ? "edit.insert" : "edit.corner", SceneEdits.name(scene, id));
    }

    @Override
    public boolean needsNoMove() {
        return inserted;
    }
}
