package troupe.paint;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;

/**
 * Is what a walker looks like from above: a disc with an arrow that points where it faces.
 *
 * @param x pixel of its middle
 * @param y pixel of its middle, down
 * @param radius in pixels
 * @param headingRad where it faces, counterclockwise from east
 */
public record Disc(double x, double y, double radius, double headingRad) {

    /** Paints the disc. */
    public void paint(Graphics2D g, Color colour) {
        g.setColor(colour);
        g.fill(round());
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(0.1, -0.45);
        arrow.lineTo(0.8, 0);
        arrow.lineTo(0.1, 0.45);
        arrow.closePath();
        AffineTransform place = AffineTransform.getTranslateInstance(x, y);
        place.rotate(-headingRad);
        place.scale(radius, radius);
        g.setColor(Color.WHITE);
        g.fill(place.createTransformedShape(arrow));
    }

    /** Paints the disc with an edge that keeps it apart from what lies below. */
    public void paint(Graphics2D g, Color colour, Color edge) {
        paint(g, colour);
        g.setColor(edge);
        g.setStroke(Theme.line(2));
        g.draw(round());
    }

    private Ellipse2D round() {
        return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    }
}
