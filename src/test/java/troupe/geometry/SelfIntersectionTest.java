package troupe.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class SelfIntersectionTest {
    private static final int TEETH = 1_000;

    /** Makes a comb with long teeth along x, or along y. */
    private static Polygon comb(boolean alongX) {
        double[] xy = new double[8 * TEETH + 4];
        int n = 0;
        for (int i = 0; i < TEETH; i++) {
            double[][] tooth = {{99, i}, {99, i + 0.4}, {2, i + 0.4}, {2, i + 1}};
            for (double[] corner : tooth) {
                xy[n++] = corner[alongX ? 0 : 1];
                xy[n++] = corner[alongX ? 1 : 0];
            }
        }
        double[][] back = {{1, TEETH}, {1, 0}};
        for (double[] corner : back) {
            xy[n++] = corner[alongX ? 0 : 1];
            xy[n++] = corner[alongX ? 1 : 0];
        }
        return Polygon.of(xy);
    }

    @Test
    void comparesFewPairsOfACombWhicheverWayItsTeethPoint() {
        for (boolean alongX : new boolean[] {true, false}) {
            SelfIntersection.Work work = new SelfIntersection.Work(50L * TEETH);
            assertEquals(Optional.empty(), SelfIntersection.find(comb(alongX), work));
            assertFalse(work.isSpent());
        }
    }

    @Test
    void givesUpWhenTheSharedWorkIsSpent() {
        SelfIntersection.Work work = new SelfIntersection.Work(10L * TEETH);
        int checked = 0;
        while (!work.isSpent() && checked < 100) {
            assertEquals(Optional.empty(), SelfIntersection.find(comb(true), work));
            checked++;
        }
        assertTrue(work.isSpent());
        Polygon bow = Polygon.of(1, 1, 3, 3, 3, 1, 1, 3);
        assertEquals(Optional.empty(), SelfIntersection.find(bow, work));
        assertEquals(
                new SelfIntersection.Edges(0, 2), SelfIntersection.find(bow).orElseThrow());
    }
}
