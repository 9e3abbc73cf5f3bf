package troupe.app.tool;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.List;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.geometry.Point;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;

/** Measures a distance and a direction; the line stays until the next one. */
public final class MeasureTool implements Tool {
    private final Look look;
    private Point from;
    private Point to;

    /** Makes the tool. */
    public MeasureTool(Look look) {
        this.look = look;
    }

    @Override
    public String key() {
        return "measure";
    }

    @Override
    public void press(Pointer pointer) {
        from = pointer.at();
        to = from;
    }

    @Override
    public void drag(Pointer pointer) {
        to = pointer.at();
    }

    @Override
    public void release(Pointer pointer) {
        to = pointer.at();
        if (from != null && from.equals(to)) {
            cancel();
        }
    }

    @Override
    public void cancel() {
        from = null;
        to = null;
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
    }

    @Override
    public Object stamp() {
        return from == null ? "" : List.of(from, to);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        if (from == null) {
            return;
        }
        double x1 = view.px(from.x());
        double y1 = view.py(from.y());
        double x2 = view.px(to.x());
        double y2 = view.py(to.y());
        Color accent = look.color(Tone.ACCENT);
        g.setColor(accent);
        g.setStroke(Theme.line(1.6f));
        g.draw(new Line2D.Double(x1, y1, x2, y2));
        g.fill(new Ellipse2D.Double(x1 - 3, y1 - 3, 6, 6));
        g.fill(new Ellipse2D.Double(x2 - 3, y2 - 3, 6, 6));
        double degrees = Math.toDegrees(Math.atan2(to.y() - from.y(), to.x() - from.x()));
        String text = Texts.number(from.distance(to), 2) + " m   " + Texts.number(degrees, 1) + "\u00b0";
        Sketch.bubble(g, look, (x1 + x2) / 2, (y1 + y2) / 2 + 4, text, false);
    }
}
