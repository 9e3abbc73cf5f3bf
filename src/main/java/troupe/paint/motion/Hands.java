package troupe.paint.motion;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.paint.Theme;
import troupe.paint.Viewport;

/** Paints the arms of an actor that holds an obstacle: two short lines from its body to the place that it holds. */
final class Hands {
    private static final double SHOULDER = 0.72;
    private static final double APART = 0.45;
    /** How far the hands reach over the edge that they hold, in radii of the body. */
    private static final double REACH = 0.32;

    private static final double HAND = 3;

    private Hands() {}

    /** Returns the point of an outline that is nearest to a place, in metres; of several the first. */
    static Point hold(Polygon outline, double x, double y) {
        Point nearest = new Point(outline.x(0), outline.y(0));
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            Point on = Segments.nearest(x, y, outline.x(j), outline.y(j), outline.x(i), outline.y(i));
            if (on.distance(x, y) < nearest.distance(x, y)) {
                nearest = on;
            }
        }
        return nearest;
    }

    /** Paints arms from a body to a hold, both in metres; {@code radius} is that of the body in pixels. */
    static void paint(Graphics2D g, Viewport view, Point body, double radius, Point hold, Color colour, Color rim) {
        double x = view.px(body.x());
        double y = view.py(body.y());
        double toX = view.px(hold.x());
        double toY = view.py(hold.y());
        double length = Math.hypot(toX - x, toY - y);
        if (length < 1e-6) {
            return;
        }
        double acrossX = -(toY - y) / length * radius;
        double acrossY = (toX - x) / length * radius;
        for (int side = -1; side <= 1; side += 2) {
            double handX = toX + REACH * acrossY + side * APART * acrossX;
            double handY = toY - REACH * acrossX + side * APART * acrossY;
            Line2D arm = new Line2D.Double(x + side * SHOULDER * acrossX, y + side * SHOULDER * acrossY, handX, handY);
            Ellipse2D hand = new Ellipse2D.Double(handX - HAND, handY - HAND, 2 * HAND, 2 * HAND);
            g.setColor(rim);
            g.setStroke(Theme.line(5.5f));
            g.draw(arm);
            g.setStroke(Theme.line(3));
            g.draw(hand);
            g.setColor(colour);
            g.draw(arm);
            g.fill(hand);
        }
    }
}
