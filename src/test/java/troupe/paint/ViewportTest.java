package troupe.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.geom.Point2D;
import org.junit.jupiter.api.Test;
import troupe.geometry.Box;

/** Converts places to pixels and back, and keeps what is pointed at while zooming. */
class ViewportTest {

    @Test
    void fitsAWideBoxToTheWidthAndCentresIt() {
        Viewport view = Viewport.fit(new Box(0, 0, 20, 10), 220, 200, 10);
        assertEquals(10, view.scale());
        assertEquals(10, view.px(0), 1e-12);
        assertEquals(210, view.px(20), 1e-12);
        assertEquals(50, view.py(10), 1e-12, "y up: the top of the box comes first");
        assertEquals(150, view.py(0), 1e-12);
    }

    @Test
    void zoomKeepsThePlaceUnderThePointer() {
        Viewport view = Viewport.fit(new Box(0, 0, 20, 10), 800, 600, 0);
        Viewport near = view.zoomed(3, 123, 456);
        assertEquals(3 * view.scale(), near.scale(), 1e-9);
        assertEquals(view.x(123), near.x(123), 1e-12);
        assertEquals(view.y(456), near.y(456), 1e-12);
        assertEquals(Viewport.MAX_SCALE, view.zoomed(1e12, 0, 0).scale());
        assertEquals(Viewport.MIN_SCALE, view.zoomed(1e-12, 0, 0).scale());
    }

    @Test
    void panMovesTheContentWithThePointer() {
        Viewport view = new Viewport(2, 8, 50);
        Viewport moved = view.panned(30, -20);
        assertEquals(view.px(3) + 30, moved.px(3), 1e-9);
        assertEquals(view.py(3) - 20, moved.py(3), 1e-9);
    }

    @Test
    void transformAgreesWithTheConversions() {
        Viewport view = new Viewport(-1.5, 7.25, 33);
        Point2D p = view.transform().transform(new Point2D.Double(4, 2), null);
        assertEquals(view.px(4), p.getX(), 1e-9);
        assertEquals(view.py(2), p.getY(), 1e-9);
        assertEquals(4, view.x(p.getX()), 1e-12);
        assertEquals(2, view.y(p.getY()), 1e-12);
    }

    @Test
    void refusesAScaleOfZero() {
        assertThrows(IllegalArgumentException.class, () -> new Viewport(0, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new Viewport(Double.NaN, 0, 1));
    }
}
