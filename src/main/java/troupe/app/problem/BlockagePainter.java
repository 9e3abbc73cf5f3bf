package troupe.app.problem;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.tool.Hits;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Scene;
import troupe.work.inspect.Blockage;

/** Paints what stands in the way of a journey, with its name, and the way it stands in. Pure. */
public final class BlockagePainter {
    private static final int HATCH = 9;

    private BlockagePainter() {}

    /** Paints a blockage of a scene. */
    public static void paint(Graphics2D g, Viewport view, Look look, Scene scene, Blockage blockage) {
        paintWay(g, view, look, blockage.way());
        for (String id : blockage.obstacles()) {
            scene.element(id).flatMap(Hits::outline).ifPresent(outline -> {
                hatch(g, view, look, outline);
                Box box = outline.bounds();
                Point at = crossing(blockage.way(), outline)
                        .orElse(new Point((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2));
                pill(g, view, look, at, SceneEdits.name(scene, id));
            });
        }
        for (Blockage.Gap gap : blockage.gaps()) {
            double radius = Math.max(9, gap.needed() / 2 * view.scale());
            g.setColor(look.color(Tone.MOVE));
            g.setStroke(Theme.line(2.2f));
            g.draw(new Ellipse2D.Double(
                    view.px(gap.at().x()) - radius, view.py(gap.at().y()) - radius, 2 * radius, 2 * radius));
            pill(g, view, look, gap.at(), Texts.number(gap.width(), 2) + " < " + Texts.number(gap.needed(), 2) + " m");
        }
    }

    private static java.util.Optional<Point> crossing(List<Point> way, Polygon outline) {
        return way.stream().filter(p -> outline.contains(p.x(), p.y())).findFirst();
    }

    private static void paintWay(Graphics2D g, Viewport view, Look look, List<Point> way) {
        Path2D path = new Path2D.Double();
        for (Point place : way) {
            if (path.getCurrentPoint() == null) {
                path.moveTo(view.px(place.x()), view.py(place.y()));
            } else {
                path.lineTo(view.px(place.x()), view.py(place.y()));
            }
        }
        g.setColor(look.theme().color(Tone.MOVE, 0.8));
        g.setStroke(Theme.line(2, 3, 6));
        g.draw(path);
    }

    private static void hatch(Graphics2D g, Viewport view, Look look, Polygon outline) {
        Path2D path = new Path2D.Double();
        for (int i = 0; i < outline.size(); i++) {
            if (i == 0) {
                path.moveTo(view.px(outline.x(i)), view.py(outline.y(i)));
            } else {
                path.lineTo(view.px(outline.x(i)), view.py(outline.y(i)));
            }
        }
        path.closePath();
        Rectangle2D box = path.getBounds2D();
        Graphics2D inside = (Graphics2D) g.create();
        inside.clip(path);
        inside.setColor(look.theme().color(Tone.MOVE, 0.75));
        inside.setStroke(Theme.line(2));
        double right = Math.min(box.getMaxX() + box.getHeight(), box.getMinX() + 6_000);
        for (double x = box.getMinX(); x < right; x += HATCH) {
            inside.draw(new java.awt.geom.Line2D.Double(x, box.getMinY(), x - box.getHeight(), box.getMaxY()));
        }
        inside.dispose();
        g.setColor(look.color(Tone.MOVE));
        g.setStroke(Theme.line(2.4f));
        g.draw(path);
    }

    private static void pill(Graphics2D g, Viewport view, Look look, Point at, String text) {
        g.setFont(look.bold());
        FontMetrics metrics = g.getFontMetrics();
        int width = metrics.stringWidth(text) + 18;
        int x = (int) (view.px(at.x()) - width / 2.0);
        int y = (int) view.py(at.y()) - 38;
        g.setColor(look.color(Tone.PANEL));
        g.fillRoundRect(x, y, width, 22, 22, 22);
        g.setColor(look.color(Tone.MOVE));
        g.setStroke(Theme.line(1.4f));
        g.drawRoundRect(x, y, width, 22, 22, 22);
        g.drawString(text, x + 9f, y + 15f);
    }
}
