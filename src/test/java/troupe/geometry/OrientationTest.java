package troupe.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Compares sides of lines with decimal arithmetic, mostly where the three points are nearly in line. */
class OrientationTest {
    private static int exact(double[] p) {
        BigDecimal[] d = new BigDecimal[6];
        for (int n = 0; n < 6; n++) {
            d[n] = new BigDecimal(p[n]);
        }
        BigDecimal left = d[0].subtract(d[4]).multiply(d[3].subtract(d[5]));
        BigDecimal right = d[1].subtract(d[5]).multiply(d[2].subtract(d[4]));
        return left.compareTo(right);
    }

    @Test
    void agreesWithDecimalArithmetic() {
        Random random = new Random(3);
        int[] counts = new int[3];
        for (int trial = 0; trial < 40_000; trial++) {
            double scale = Math.scalb(1.0, random.nextInt(20) == 0 ? -random.nextInt(540) : 0);
            double x = random.nextInt(100) * 0.1;
            double y = random.nextInt(100) * 0.1;
            int dx = random.nextInt(9) - 4;
            int dy = random.nextInt(9) - 4;
            double[] p = {x, y, x + 0.1 * dx, y + 0.1 * dy, x + 0.3 * dx, y + 0.3 * dy};
            if (random.nextInt(3) == 0) {
                int n = random.nextInt(6);
                p[n] = random.nextBoolean() ? Math.nextUp(p[n]) : p[n] + 1e-9 * random.nextDouble();
            }
            for (int n = 0; n < 6; n++) {
                p[n] *= scale;
            }
            int side = Orientation.sign(p[0], p[1], p[2], p[3], p[4], p[5]);
            assertEquals(exact(p), side, () -> java.util.Arrays.toString(p));
            counts[side + 1]++;
        }
        for (int count : counts) {
            assertTrue(count > 4000, java.util.Arrays.toString(counts));
        }
    }
}
