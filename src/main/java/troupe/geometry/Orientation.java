package troupe.geometry;

import java.math.BigDecimal;

/**
 * Decides on which side of a line a point lies, exactly for all finite doubles: a floating-point filter
 * (Shewchuk 1997, error bound A) answers nearly always, the rounding errors of the two products where all
 * else is exact, exact decimal arithmetic the rest.
 */
public final class Orientation {
    private static final double FILTER = (3 + 16 * Math.ulp(0.5)) * Math.ulp(0.5);

    /** Products larger than this leave what is lost by rounding them large enough for a double. */
    private static final double LEAST = 1e-200;

    private Orientation() {}

    /**
     * Returns +1 if {@code c} lies to the left of the line from {@code a} to {@code b}, -1 if to the right,
     * 0 if the three are in line.
     */
    public static int sign(double ax, double ay, double bx, double by, double cx, double cy) {
        double acx = ax - cx;
        double bcy = by - cy;
        double acy = ay - cy;
        double bcx = bx - cx;
        double left = acx * bcy;
        double right = acy * bcx;
        double det = left - right;
        double bound = FILTER * (Math.abs(left) + Math.abs(right));
        if (det > bound || -det > bound) {
            return det > 0 ? 1 : -1;
        }
        if (left == right
                && tail(ax, cx, acx) == 0
                && tail(by, cy, bcy) == 0
                && tail(ay, cy, acy) == 0
                && tail(bx, cx, bcx) == 0
                && (left == 0 ? isPlain(acx, bcy, acy, bcx) : Math.abs(left) > LEAST)) {
            double lostLeft = Math.fma(acx, bcy, -left);
            double lostRight = Math.fma(acy, bcx, -right);
            return lostLeft > lostRight ? 1 : lostLeft < lostRight ? -1 : 0;
        }
        return exact(ax, ay, bx, by, cx, cy);
    }

    /** Tells whether both products are 0 because a factor is, not because they are too small for a double. */
    private static boolean isPlain(double a, double b, double c, double d) {
        return (a == 0 || b == 0) && (c == 0 || d == 0);
    }

    /** Returns what rounding took from the difference {@code a - b} (Shewchuk's Two-Diff-Tail). */
    private static double tail(double a, double b, double difference) {
        double bVirtual = a - difference;
        double aVirtual = difference + bVirtual;
        return (a - aVirtual) + (bVirtual - b);
    }

    private static int exact(double ax, double ay, double bx, double by, double cx, double cy) {
        BigDecimal x = new BigDecimal(cx);
        BigDecimal y = new BigDecimal(cy);
        BigDecimal left = new BigDecimal(ax).subtract(x).multiply(new BigDecimal(by).subtract(y));
        BigDecimal right = new BigDecimal(ay).subtract(y).multiply(new BigDecimal(bx).subtract(x));
        return left.compareTo(right);
    }
}
