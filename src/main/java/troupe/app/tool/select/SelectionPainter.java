package troupe.app.tool.select;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import troupe.app.document.Mark;
import troupe.app.document.SceneEdits;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.tool.Sketch;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Scene;

/** Paints the outlines of what is selected. Pure. */
public final class SelectionPainter {
    private static final double RING = 12;

    private SelectionPainter() {}

    /** Paints the outlines of what is selected in a scene. */
    public static void paint(Graphics2D g, Viewport view, Look look, Scene scene, Selection selection) {
        for (String id : selection.ids()) {
            SceneEdits.outline(scene, id).ifPresent(outline -> paint(g, view, look, outline));
            scene.task(id).ifPresent(task -> Mark.of(task).stream()
                    .filter(mark -> mark.owner().equals(id))
                    .forEach(mark -> ring(g, view, look, mark)));
            Mark.find(scene, id).ifPresent(mark -> ring(g, view, look, mark));
        }
    }

    private static void ring(Graphics2D g, Viewport view, Look look, Mark mark) {
        double px = view.px(mark.place().x());
        double py = view.py(mark.place().y());
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line(2));
        g.draw(new Ellipse2D.Double(px - RING, py - RING, 2 * RING, 2 * RING));
    }

    private static void paint(Graphics2D g, Viewport view, Look look, Polygon outline) {
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line(2));
        g.draw(Sketch.path(outline, view));
    }
}
