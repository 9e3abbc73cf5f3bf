package troupe.app.canvas;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Scene;

/** Paints the outline and the corners of what is selected. Pure. */
final class SelectionPainter {
    private static final int MOST_CORNERS = 60;

    private SelectionPainter() {}

    static void paint(Graphics2D g, Viewport view, Look look, Scene scene, Selection selection) {
        for (String id : selection.ids()) {
            scene.element(id).flatMap(Hits::outline).ifPresent(outline -> paint(g, view, look, outline));
        }
    }

    private static void paint(Graphics2D g, Viewport view, Look look, Polygon outline) {
        Path2D path = new Path2D.Double();
        for (int i = 0; i < outline.size(); i++) {
            double x = view.px(outline.x(i));
            double y = view.py(outline.y(i));
            if (i == 0) {
                path.moveTo(x, y);
            } else {
                path.lineTo(x, y);
            }
        }
        path.closePath();
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line(2));
        g.draw(path);
        for (int i = 0; i < outline.size() && outline.size() <= MOST_CORNERS; i++) {
            Rectangle2D corner = new Rectangle2D.Double(view.px(outline.x(i)) - 3.5, view.py(outline.y(i)) - 3.5, 7, 7);
            g.setColor(look.color(Tone.PANEL));
            g.fill(corner);
            g.setColor(look.color(Tone.ACCENT));
            g.setStroke(Theme.line(1.5f));
            g.draw(corner);
        }
    }
}
