package troupe.paint.motion;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** Marks the members of a group by a sign that points where they head, so that colour is never alone. */
enum GroupMark {
    ARROW(arrow()),
    BAR(new Rectangle2D.Double(-0.6, -0.19, 1.45, 0.38)),
    DOT(new Ellipse2D.Double(0.02, -0.36, 0.72, 0.72)),
    CHEVRON(chevron()),
    HALF(new Arc2D.Double(-0.78, -0.78, 1.56, 1.56, -90, 180, Arc2D.CHORD)),
    TEE(tee());

    private final Shape sign;

    GroupMark(Shape sign) {
        this.sign = sign;
    }

    /** Returns the mark of a group by its number; they come round again. */
    static GroupMark of(int number) {
        return values()[number % values().length];
    }

    private static Path2D arrow() {
        return path(0.95, 0, -0.55, 0.45, -0.55, -0.45);
    }

    private static Path2D chevron() {
        return path(0.85, 0, 0, 0.75, -0.42, 0.6, 0.2, 0, -0.42, -0.6, 0, -0.75);
    }

    private static Area tee() {
        Area area = new Area(new Rectangle2D.Double(-0.5, -0.15, 1.35, 0.3));
        area.add(new Area(new Rectangle2D.Double(-0.6, -0.55, 0.34, 1.1)));
        return area;
    }

    private static Path2D path(double... xy) {
        Path2D path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        for (int k = 2; k < xy.length; k += 2) {
            path.lineTo(xy[k], xy[k + 1]);
        }
        path.closePath();
        return path;
    }

    /** Fills the sign on a disc of {@code radius} pixels that heads {@code headingRad} counter-clockwise from the right. */
    void fill(Graphics2D g, double x, double y, double radius, double headingRad) {
        AffineTransform place = AffineTransform.getTranslateInstance(x, y);
        place.rotate(-headingRad);
        place.scale(radius, radius);
        g.fill(place.createTransformedShape(sign));
    }
}
