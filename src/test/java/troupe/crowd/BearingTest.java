package troupe.crowd;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class BearingTest {
    @Test
    void agreesWithTheArcTangentAllAround() {
        for (int k = 0; k < 100_000; k++) {
            double angle = k * 2 * Math.PI / 100_000 - Math.PI;
            double x = 1.7 * Math.cos(angle);
            double y = 1.7 * Math.sin(angle);
            assertEquals(StrictMath.atan2(y, x), Bearing.of(x, y), 1e-8, "angle " + angle);
        }
    }

    @Test
    void knowsTheAxesAndNothing() {
        assertEquals(0, Bearing.of(0, 0));
        assertEquals(0, Bearing.of(1, 0));
        assertEquals(Math.PI / 2, Bearing.of(0, 2));
        assertEquals(Math.PI, Bearing.of(-1, 0));
        assertEquals(-Math.PI / 2, Bearing.of(0, -3));
        assertEquals(Math.PI / 4, Bearing.of(5, 5));
    }
}
