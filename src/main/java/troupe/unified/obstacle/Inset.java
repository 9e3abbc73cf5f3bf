package troupe.unified.obstacle;

import troupe.geometry.Polygon;

/**
 * Draws a simple polygon in by a distance that is small against all its edges, so that what only touched
 * the polygon is clear of the result by that distance. Each edge moves inwards; corners sharper than
 * {@link #SHARPEST} are cut back less than their edges meet.
 */
final class Inset {
    /** The farthest that a corner moves, in multiples of the distance. */
    private static final double SHARPEST = 64;

    private Inset() {}

    /** Returns the polygon drawn in by {@code distance} metres, without corners that repeat the one before. */
    static Polygon of(Polygon polygon, double distance) {
        int[] corners = distinct(polygon);
        int size = corners.length;
        if (size < 3) {
            return polygon;
        }
        double inward = polygon.signedArea() >= 0 ? distance : -distance;
        double[] xs = new double[size];
        double[] ys = new double[size];
        for (int n = 0; n < size; n++) {
            int before = corners[(n + size - 1) % size];
            int at = corners[n];
            int after = corners[(n + 1) % size];
            double ux = polygon.x(at) - polygon.x(before);
            double uy = polygon.y(at) - polygon.y(before);
            double vx = polygon.x(after) - polygon.x(at);
            double vy = polygon.y(after) - polygon.y(at);
            double u = Math.sqrt(ux * ux + uy * uy);
            double v = Math.sqrt(vx * vx + vy * vy);
            double mx = -uy / u - vy / v;
            double my = ux / u + vx / v;
            double half = (mx * mx + my * my) / 2;
            double scale = inward / Math.max(half, 2 / (SHARPEST * SHARPEST));
            xs[n] = polygon.x(at) + scale * mx;
            ys[n] = polygon.y(at) + scale * my;
        }
        return new Polygon(xs, ys);
    }

    private static int[] distinct(Polygon polygon) {
        int[] kept = new int[polygon.size()];
        int count = 0;
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            if (polygon.x(i) != polygon.x(j) || polygon.y(i) != polygon.y(j)) {
                kept[count++] = i;
            }
        }
        return java.util.Arrays.copyOf(kept, count);
    }
}
