package troupe.app.tool.select;

import java.util.List;
import java.util.Optional;
import troupe.app.document.Outlines;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.app.tool.Editing;
import troupe.app.tool.Guide;
import troupe.app.tool.Pointer;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.scene.Scene;

/** Turns what is selected about its middle: in whole degrees, with Shift in steps of 15, with Alt freely. */
final class TurnGesture implements Gesture {
    private static final double COARSE = 15;

    private final Editing editing;
    private final Pointer from;
    private final Scene scene;
    private final List<String> ids;
    private final Point middle;

    TurnGesture(Editing editing, Pointer from, Box box) {
        this.editing = editing;
        this.from = from;
        this.scene = editing.document().scene();
        this.ids = editing.selection().ids();
        this.middle = ids.size() == 1
                ? SceneEdits.outline(scene, ids.get(0)).orElseThrow().centroid()
                : new Point((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2);
    }

    private double angle(Point at) {
        return Math.toDegrees(Math.atan2(at.y() - middle.y(), at.x() - middle.x()));
    }

    @Override
    public Outcome at(Pointer pointer) {
        double degrees = Math.IEEEremainder(angle(pointer.at()) - angle(from.at()), 360);
        if (pointer.shift()) {
            degrees = Math.rint(degrees / COARSE) * COARSE;
        } else if (!pointer.alt()) {
            degrees = Math.rint(degrees);
        }
        double rad = Math.toRadians(degrees);
        Scene turned = SceneEdits.reshaped(scene, ids, outline -> Outlines.turned(outline, middle, rad));
        Optional<Guide> guide =
                pointer.shift() ? Optional.of(new Guide(Guide.Kind.ANGLE, middle, pointer.at())) : Optional.empty();
        return new Outcome(turned, pointer.at(), guide, Texts.number(degrees, 1) + "\u00b0", Optional.empty());
    }

    @Override
    public String name() {
        return ids.size() == 1
                ? editing.texts().format("edit.turn", SceneEdits.name(scene, ids.get(0)))
                : editing.texts().format("edit.turn.several", ids.size());
    }
}
