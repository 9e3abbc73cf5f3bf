package troupe.app.tool.select;

import java.awt.Graphics2D;
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
    private SelectionPainter() {}

    /** Paints the outlines of what is selected in a scene. */
    public static void paint(Graphics2D g, Viewport view, Look look, Scene scene, Selection selection) {
        for (String id : selection.ids()) {
            SceneEdits.outline(scene, id).ifPresent(outline -> paint(g, view, look, outline));
        }
    }

    private static void paint(Graphics2D g, Viewport view, Look look, Polygon outline) {
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line(2));
        g.draw(Sketch.path(outline, view));
    }
}
