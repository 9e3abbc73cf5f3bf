package troupe.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Checks arcs against hand-worked cases and against points laid densely along them. */
class ArcsTest {
    private static final int POINTS = 4000;

    @Test
    void quarterTurnMeetsWhatLiesInItsQuarter() {
        assertTrue(Arcs.meet(1, 0, 0, 1, false, 0, 0, 2, 2));
        assertFalse(Arcs.meet(1, 0, 0, 1, false, 0, 0, -2, -2));
        assertFalse(Arcs.meet(1, 0, 0, 1, false, 0, 0, 0.5, 0.5), "inside of the circle");
        assertFalse(Arcs.meet(1, 0, 0, 1, false, 1.1, 0, 1.1, 2), "outside of the circle");
        assertTrue(Arcs.meet(1, 0, 0, 1, false, 0.9, -1, 0.9, 2), "crosses where the arc has risen");
        assertFalse(Arcs.meet(1, 0, 0, 1, false, 0.9, -1, 0.9, 0.1), "crosses the circle below the arc only");
    }

    @Test
    void wideTurnLeavesOutTheRest() {
        assertTrue(Arcs.meet(1, 0, 0, -1, true, 0, 0, -2, -2));
        assertFalse(Arcs.meet(1, 0, 0, -1, true, 0, 0, 2, -2));
    }

    @Test
    void arcThroughACornerMeetsAnEdgeOfIt() {
        // a corner at (0.6, 0.8), exactly on the circle up to rounding, its edges outside but for it
        double x = 0.6;
        double y = 0.8;
        boolean first = Arcs.meet(1, 0, 0, 1, false, 3, 1, x, y);
        boolean second = Arcs.meet(1, 0, 0, 1, false, x, y, 1, 3);
        assertTrue(first || second);
    }

    @Test
    void agreesWithPointsAlongTheArc() {
        Random random = new Random(31);
        int met = 0;
        int sure = 0;
        for (int trial = 0; trial < 2000; trial++) {
            double radius = 0.2 + random.nextDouble();
            double start = 2 * Math.PI * random.nextDouble();
            double turn = (random.nextInt(4) == 0 ? 1.9 * Math.PI : 0.6) * (0.05 + 0.95 * random.nextDouble());
            double[] c = random.doubles(4, -1.5, 1.5).toArray();
            double least = Double.POSITIVE_INFINITY;
            int side = 0;
            boolean crossed = false;
            for (int n = 0; n <= POINTS; n++) {
                double angle = start + turn * n / POINTS;
                double x = radius * Math.cos(angle);
                double y = radius * Math.sin(angle);
                double distance = Math.sqrt(Segments.distanceSquared(x, y, c[0], c[1], c[2], c[3]));
                int now = Orientation.sign(c[0], c[1], c[2], c[3], x, y);
                crossed |= n > 0 && now != side && distance < 1e-3 * radius * turn;
                side = now;
                least = Math.min(least, distance);
            }
            boolean meets = Arcs.meet(
                    radius * Math.cos(start),
                    radius * Math.sin(start),
                    radius * Math.cos(start + turn),
                    radius * Math.sin(start + turn),
                    turn > Math.PI,
                    c[0],
                    c[1],
                    c[2],
                    c[3]);
            if (crossed || least > radius * turn / POINTS) {
                assertEquals(crossed, meets, "trial " + trial);
                sure++;
                met += meets ? 1 : 0;
            }
        }
        assertTrue(met > 200 && sure - met > 200, met + " of " + sure);
    }
}
