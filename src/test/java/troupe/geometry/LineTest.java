package troupe.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class LineTest {

    @Test
    void measuresTheDistanceToAnOutline() {
        Line line = new Line(0, 0, 4, 0);
        assertEquals(2, line.distance(Polygon.rectangle(1, 2, 3, 5)));
        assertEquals(5, line.distance(Polygon.rectangle(7, 4, 9, 9)));
        assertEquals(0, line.distance(Polygon.rectangle(1, -1, 2, 1)));
    }

    /** The sign of the corner against the diagonal is lost in a plain product of differences. */
    @Test
    void tellsACornerThatHardlyReachesOver() {
        Line line = new Line(-12, -12, 12, 12);
        assertTrue(line.crosses(Polygon.of(0.5, Math.nextUp(0.5), 0.5, -5, 3, -5)));
        assertFalse(line.crosses(Polygon.of(0.5, 0.5, 0.5, -5, 3, -5)));
    }
}
