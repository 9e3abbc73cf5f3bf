package troupe.geometry;

import java.math.BigDecimal;

/**
 * Decides on which side of a line a point lies, exactly for all finite doubles: a floating-point filter
 * (Shewchuk 1997, error bound A) answers nearly always, exact decimal arithmetic the rest.
 */
public final class Orientation {
    private static final double FILTER = (3 + 16 * Math.ulp(0.5)) * Math.ulp(0.5);

    private Orientation() {}

    /**
     * Returns +1 if {@code c} lies to the left of the line from {@code a} to {@code b}, -1 if to the right,
     * 0 if the three are in line.
     */
    public static int sign(double ax, double ay, double bx, double by, double cx, double cy) {
        double left = (ax - cx) * (by - cy);
        double right = (ay - cy) * (bx - cx);
        double det = left - right;
        double bound = FILTER * (Math.abs(left) + Math.abs(right));
        if (det > bound || -det > bound) {
            return det > 0 ? 1 : -1;
        }
        return exact(ax, ay, bx, by, cx, cy);
    }

    private static int exact(double ax, double ay, double bx, double by, double cx, double cy) {
        BigDecimal x = new BigDecimal(cx);
        BigDecimal y = new BigDecimal(cy);
        BigDecimal left = new BigDecimal(ax).subtract(x).multiply(new BigDecimal(by).subtract(y));
        BigDecimal right = new BigDecimal(ay).subtract(y).multiply(new BigDecimal(bx).subtract(x));
        return left.compareTo(right);
    }
}
