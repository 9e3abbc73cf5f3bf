package troupe.app.tool;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import troupe.app.look.Look;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;

/** Paints what tools show besides the scene: shapes under way, guides, bubbles with a text. Pure. */
public final class Sketch {
    private static final int BEYOND = 2_000;

    private Sketch() {}

    /** Returns the pixels of an outline. */
    public static Path2D path(Polygon outline, Viewport view) {
        Path2D path = new Path2D.Double();
        for (int i = 0; i < outline.size(); i++) {
            if (i == 0) {
                path.moveTo(view.px(outline.x(i)), view.py(outline.y(i)));
            } else {
                path.lineTo(view.px(outline.x(i)), view.py(outline.y(i)));
            }
        }
        path.closePath();
        return path;
    }

    /** Paints an outline that is not part of the scene yet; red and dashed when it is wrong. */
    public static void outline(Graphics2D g, Viewport view, Look look, Polygon outline, boolean wrong) {
        Path2D path = path(outline, view);
        g.setColor(look.theme().color(wrong ? Tone.MOVE : Tone.ACCENT, 0.15));
        g.fill(path);
        g.setColor(look.color(wrong ? Tone.MOVE : Tone.ACCENT));
        g.setStroke(wrong ? Theme.line(2, 6, 4) : Theme.line(2));
        g.draw(path);
    }

    /** Paints a corner as a small square, filled when it is the one in hand. */
    public static void corner(Graphics2D g, Viewport view, Look look, Point at, boolean active) {
        Rectangle2D square = new Rectangle2D.Double(view.px(at.x()) - 3.5, view.py(at.y()) - 3.5, 7, 7);
        g.setColor(look.color(active ? Tone.ACCENT : Tone.PANEL));
        g.fill(square);
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line(1.5f));
        g.draw(square);
    }

    /** Paints what a place was snapped to. */
    public static void guide(Graphics2D g, Viewport view, Look look, Optional<Guide> shown, Point at) {
        if (shown.isEmpty()) {
            return;
        }
        Guide guide = shown.get();
        double x = view.px(at.x());
        double y = view.py(at.y());
        Color color = look.color(Tone.STRIDE);
        g.setColor(color);
        g.setStroke(Theme.line(1.4f));
        switch (guide.kind()) {
            case CORNER -> {
                g.draw(new Rectangle2D.Double(x - 6, y - 6, 12, 12));
                g.fill(new Ellipse2D.Double(x - 2, y - 2, 4, 4));
            }
            case EDGE -> {
                g.setStroke(Theme.line(2.4f));
                g.draw(line(view, guide.from(), guide.to()));
                g.fill(new Ellipse2D.Double(x - 3.5, y - 3.5, 7, 7));
            }
            case ANGLE -> {
                g.setStroke(
                        new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {5, 4}, 0));
                double ax = view.px(guide.from().x());
                double ay = view.py(guide.from().y());
                double length = Math.max(1e-9, Math.hypot(x - ax, y - ay));
                double ux = (x - ax) / length * BEYOND;
                double uy = (y - ay) / length * BEYOND;
                g.draw(new Line2D.Double(ax - ux, ay - uy, ax + ux, ay + uy));
            }
            case GRID -> {
                g.draw(new Line2D.Double(x - 5, y, x + 5, y));
                g.draw(new Line2D.Double(x, y - 5, x, y + 5));
            }
        }
    }

    /** Returns a line between places in metres, in pixels. */
    public static Line2D line(Viewport view, Point from, Point to) {
        return new Line2D.Double(view.px(from.x()), view.py(from.y()), view.px(to.x()), view.py(to.y()));
    }

    /** Paints an open line through places. */
    public static void line(Graphics2D g, Viewport view, Look look, List<Point> places, boolean wrong) {
        g.setColor(look.color(wrong ? Tone.MOVE : Tone.ACCENT));
        g.setStroke(Theme.line(2));
        for (int i = 1; i < places.size(); i++) {
            g.draw(line(view, places.get(i - 1), places.get(i)));
        }
    }

    /** Paints a text on a small card, its middle above a pixel. */
    public static void bubble(Graphics2D g, Look look, double px, double py, String text, boolean wrong) {
        if (text.isEmpty()) {
            return;
        }
        g.setFont(look.font());
        FontMetrics metrics = g.getFontMetrics();
        int width = metrics.stringWidth(text) + 16;
        card(g, look, (int) (px - width / 2.0), (int) (py - 34), text, wrong);
    }

    /** Paints a text on a small card beside the pointer. */
    public static void beside(Graphics2D g, Look look, double px, double py, String text, boolean wrong) {
        if (!text.isEmpty()) {
            card(g, look, (int) px + 16, (int) py + 14, text, wrong);
        }
    }

    private static void card(Graphics2D g, Look look, int x, int y, String text, boolean wrong) {
        g.setFont(look.font());
        int width = g.getFontMetrics().stringWidth(text) + 16;
        g.setColor(look.color(Tone.PANEL));
        g.fillRoundRect(x, y, width, 22, 11, 11);
        g.setColor(look.color(wrong ? Tone.MOVE : Tone.ACCENT));
        g.setStroke(Theme.line(1));
        g.drawRoundRect(x, y, width, 22, 11, 11);
        g.setColor(look.color(Tone.TEXT));
        g.drawString(text, x + 8f, y + 15f);
    }
}
