package troupe.geometry;

/** Tells whether two simple polygons share area. */
public final class Overlap {
    private Overlap() {}

    /**
     * Tells whether the insides of two simple polygons share a point; polygons that only touch do not.
     * Exact where their edges cross; where all contact is along edges or at corners, points just inside
     * each outline (by {@code 1e-7} of its size) decide. Cost O(n m).
     */
    public static boolean of(Polygon a, Polygon b) {
        if (!a.bounds().meets(b.bounds())) {
            return false;
        }
        return edgesCross(a, b) || entersInside(a, b) || entersInside(b, a);
    }

    private static boolean edgesCross(Polygon a, Polygon b) {
        for (int i = 0, j = a.size() - 1; i < a.size(); j = i++) {
            for (int k = 0, l = b.size() - 1; k < b.size(); l = k++) {
                if (Segments.cross(a.x(j), a.y(j), a.x(i), a.y(i), b.x(l), b.y(l), b.x(k), b.y(k))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Looks just inside the middle of each piece of {@code a}'s outline, cut where corners of {@code b} lie on it. */
    private static boolean entersInside(Polygon a, Polygon b) {
        double inward = a.signedArea() >= 0 ? 1e-7 : -1e-7;
        for (int i = 0, j = a.size() - 1; i < a.size(); j = i++) {
            double[] cuts = cuts(a, j, i, b);
            for (int k = 0; k + 1 < cuts.length; k++) {
                double t = (cuts[k] + cuts[k + 1]) / 2;
                double dx = a.x(i) - a.x(j);
                double dy = a.y(i) - a.y(j);
                if (cuts[k + 1] > cuts[k] && b.contains(a.x(j) + t * dx - inward * dy, a.y(j) + t * dy + inward * dx)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static double[] cuts(Polygon a, int from, int to, Polygon b) {
        double dx = a.x(to) - a.x(from);
        double dy = a.y(to) - a.y(from);
        java.util.stream.DoubleStream.Builder cuts = java.util.stream.DoubleStream.builder();
        cuts.add(0).add(1);
        for (int k = 0; k < b.size(); k++) {
            if (Orientation.sign(a.x(from), a.y(from), a.x(to), a.y(to), b.x(k), b.y(k)) == 0) {
                double t = ((b.x(k) - a.x(from)) * dx + (b.y(k) - a.y(from)) * dy) / (dx * dx + dy * dy);
                if (t > 0 && t < 1) {
                    cuts.add(t);
                }
            }
        }
        return cuts.build().sorted().toArray();
    }
}
