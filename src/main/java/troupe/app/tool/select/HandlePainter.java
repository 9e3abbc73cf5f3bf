package troupe.app.tool.select;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import troupe.app.look.Look;
import troupe.app.tool.Sketch;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;

/** Paints what the pointer can take hold of on a selection. Pure. */
final class HandlePainter {
    private HandlePainter() {}

    /** Paints the handles; {@code active} is the number of the corner in hand, or negative. */
    static void paint(Graphics2D g, Viewport view, Look look, Optional<Handles> shown, int active) {
        if (shown.isEmpty()) {
            return;
        }
        Handles handles = shown.get();
        double[] low = handles.frameCorner(0, view);
        double[] high = handles.frameCorner(2, view);
        double[] knob = handles.knob(view);
        g.setColor(look.theme().color(Tone.ACCENT, 0.45));
        g.setStroke(Theme.line(1, 3, 3));
        g.draw(new Rectangle2D.Double(low[0], high[1], high[0] - low[0], low[1] - high[1]));
        g.draw(new Line2D.Double(knob[0], high[1], knob[0], knob[1]));
        g.setStroke(Theme.line(1.4f));
        for (int i = 0; i < 4; i++) {
            double[] at = handles.frameCorner(i, view);
            mark(g, look, new Rectangle2D.Double(at[0] - 4, at[1] - 4, 8, 8));
        }
        mark(g, look, new Ellipse2D.Double(knob[0] - 5, knob[1] - 5, 10, 10));
        if (handles.corners().isPresent()) {
            Polygon outline = handles.corners().get();
            for (int i = 0; i < outline.size(); i++) {
                Sketch.corner(g, view, look, new Point(outline.x(i), outline.y(i)), i == active);
            }
        }
    }

    private static void mark(Graphics2D g, Look look, java.awt.Shape shape) {
        g.setColor(look.color(Tone.PANEL));
        g.fill(shape);
        g.setColor(look.color(Tone.ACCENT));
        g.draw(shape);
    }
}
