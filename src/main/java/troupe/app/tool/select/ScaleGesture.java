package troupe.app.tool.select;

import java.util.List;
import java.util.Optional;
import troupe.app.document.Outlines;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.app.tool.Editing;
import troupe.app.tool.Guide;
import troupe.app.tool.Pointer;
import troupe.app.tool.Snap;
import troupe.app.tool.Snapping;
import troupe.geometry.Point;
import troupe.scene.Scene;

/** Stretches what is selected from one corner of its frame; the opposite one stays. Shift keeps the proportions. */
final class ScaleGesture implements Gesture {
    /** What is scaled stays at least so wide and deep, in metres. */
    private static final double LEAST = 0.02;

    private final Editing editing;
    private final Pointer from;
    private final Scene scene;
    private final List<String> ids;
    private final Point corner;
    private final Point fixed;

    ScaleGesture(Editing editing, Pointer from, Handles handles, int corner) {
        this.editing = editing;
        this.from = from;
        this.scene = editing.document().scene();
        this.ids = editing.selection().ids();
        this.corner = handles.boxCorner(corner);
        this.fixed = handles.boxCorner((corner + 2) % 4);
    }

    @Override
    public Outcome at(Pointer pointer) {
        Point wanted = new Point(
                corner.x() + pointer.at().x() - from.at().x(),
                corner.y() + pointer.at().y() - from.at().y());
        Snap snap = new Snapping(scene, ids, editing.view().get().scale())
                .place(wanted, Optional.empty(), false, pointer.alt());
        double width = corner.x() - fixed.x();
        double depth = corner.y() - fixed.y();
        double x = factor(snap.at().x() - fixed.x(), width);
        double y = factor(snap.at().y() - fixed.y(), depth);
        if (pointer.shift()) {
            x = Math.max(x, y);
            y = x;
        }
        double fx = x;
        double fy = y;
        Scene scaled = SceneEdits.reshaped(scene, ids, outline -> Outlines.scaled(outline, fixed, fx, fy));
        String text = Texts.number(Math.abs(width * x), 2) + " \u00d7 " + Texts.number(Math.abs(depth * y), 2) + " m";
        Optional<Guide> guide = pointer.shift() ? Optional.empty() : snap.guide();
        return new Outcome(scaled, snap.at(), guide, text, Optional.empty());
    }

    private static double factor(double now, double before) {
        return Math.max(now / before, LEAST / Math.abs(before));
    }

    @Override
    public String name() {
        return ids.size() == 1
                ? editing.texts().format("edit.scale", SceneEdits.name(scene, ids.get(0)))
                : editing.texts().format("edit.scale.several", ids.size());
    }
}
