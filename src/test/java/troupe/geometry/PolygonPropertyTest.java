package troupe.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Path2D;
import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Holds the plane geometry against exact arithmetic and slow references. */
class PolygonPropertyTest {
    private static final long SEED = Long.getLong("troupe.seed", 20_260_102);

    @Test
    void orientationIsExactForPointsNearlyInLine() {
        Random random = new Random(SEED);
        for (int i = 0; i < 20_000; i++) {
            double ax = random.nextDouble();
            double ay = random.nextDouble();
            double bx = ax + random.nextDouble();
            double by = ay + random.nextDouble();
            double t = random.nextDouble();
            double cx = ax + t * (bx - ax);
            double cy = ay + t * (by - ay) + (random.nextInt(3) - 1) * Math.ulp(ay);
            BigDecimal exact = exactDeterminant(ax, ay, bx, by, cx, cy);
            assertEquals(exact.signum(), Orientation.sign(ax, ay, bx, by, cx, cy), "seed " + SEED);
        }
    }

    private static BigDecimal exactDeterminant(double ax, double ay, double bx, double by, double cx, double cy) {
        BigDecimal x = new BigDecimal(cx);
        BigDecimal y = new BigDecimal(cy);
        return new BigDecimal(ax)
                .subtract(x)
                .multiply(new BigDecimal(by).subtract(y))
                .subtract(new BigDecimal(ay).subtract(y).multiply(new BigDecimal(bx).subtract(x)));
    }

    @Test
    void insideAgreesWithTheToolkitsEvenOddRule() {
        Random random = new Random(SEED);
        for (int i = 0; i < 2_000; i++) {
            Polygon polygon = random(random, 3 + random.nextInt(9));
            Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
            path.moveTo(polygon.x(0), polygon.y(0));
            for (int k = 1; k < polygon.size(); k++) {
                path.lineTo(polygon.x(k), polygon.y(k));
            }
            path.closePath();
            for (int k = 0; k < 20; k++) {
                double x = random.nextDouble() * 10;
                double y = random.nextDouble() * 10;
                if (polygon.distanceToOutline(x, y) > 1e-9) {
                    assertEquals(path.contains(x, y), polygon.contains(x, y), "seed " + SEED + ", " + polygon);
                }
            }
        }
    }

    private static Polygon random(Random random, int corners) {
        double[] coordinates = random.doubles(2L * corners).map(v -> 10 * v).toArray();
        return Polygon.of(coordinates);
    }

    @Test
    void polygonsThatShareAnEdgeTileEveryPointOnce() {
        Random random = new Random(SEED);
        for (int i = 0; i < 2_000; i++) {
            double x = random.nextInt(9);
            double y = random.nextInt(9);
            Polygon left = Polygon.of(0, 0, x, y, 9, 9, 0, 9);
            Polygon right = Polygon.of(0, 0, 9, 0, 9, 9, x, y);
            for (int k = 0; k < 30; k++) {
                double px = random.nextInt(17) / 2.0 + 0.25;
                double py = random.nextInt(18) / 2.0;
                if (SelfIntersection.find(left).isEmpty()
                        && SelfIntersection.find(right).isEmpty()) {
                    assertTrue(
                            left.contains(px, py) ^ right.contains(px, py), left + " " + right + " " + px + "," + py);
                }
            }
        }
    }

    @Test
    void selfIntersectionAgreesWithAllPairs() {
        Random random = new Random(SEED);
        int simple = 0;
        for (int i = 0; i < 5_000; i++) {
            int n = 3 + random.nextInt(5);
            double[] coordinates = random.ints(2L * n, 0, 6).asDoubleStream().toArray();
            Polygon polygon = Polygon.of(coordinates);
            boolean found = SelfIntersection.find(polygon).isPresent();
            assertEquals(meetsItself(polygon), found, "seed " + SEED + ", " + polygon);
            simple += found ? 0 : 1;
        }
        assertTrue(simple > 200, simple + " simple polygons");
    }

    /** Says by all pairs of edges, at integer corners, whether an outline meets itself. */
    private static boolean meetsItself(Polygon p) {
        int n = p.size();
        for (int i = 0; i < n; i++) {
            int i1 = (i + 1) % n;
            if (p.x(i) == p.x(i1) && p.y(i) == p.y(i1)) {
                return true;
            }
            for (int j = i + 1; j < n; j++) {
                int j1 = (j + 1) % n;
                boolean neighbours = i1 == j || j1 == i;
                if (neighbours) {
                    int shared = i1 == j ? j : i;
                    int before = i1 == j ? i : j;
                    int after = i1 == j ? j1 : i1;
                    double cross = (p.x(shared) - p.x(before)) * (p.y(after) - p.y(shared))
                            - (p.y(shared) - p.y(before)) * (p.x(after) - p.x(shared));
                    double dot = (p.x(shared) - p.x(before)) * (p.x(after) - p.x(shared))
                            + (p.y(shared) - p.y(before)) * (p.y(after) - p.y(shared));
                    if (cross == 0 && dot < 0) {
                        return true;
                    }
                } else if (java.awt.geom.Line2D.linesIntersect(
                        p.x(i), p.y(i), p.x(i1), p.y(i1), p.x(j), p.y(j), p.x(j1), p.y(j1))) {
                    return true;
                }
            }
        }
        return false;
    }

    @Test
    void segmentDistanceAgreesWithDenseSamples() {
        Random random = new Random(SEED);
        for (int i = 0; i < 500; i++) {
            double[] v = random.doubles(8).toArray();
            double least = Double.POSITIVE_INFINITY;
            for (int k = 0; k <= 400; k++) {
                double t = k / 400.0;
                least = Math.min(
                        least,
                        Segments.distanceSquared(
                                v[0] + t * (v[2] - v[0]), v[1] + t * (v[3] - v[1]), v[4], v[5], v[6], v[7]));
            }
            double exact = Segments.distanceSquared(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
            assertEquals(Math.sqrt(least), Math.sqrt(exact), 4e-3, "seed " + SEED);
            assertTrue(exact <= least + 1e-12);
        }
    }

    @Test
    void turnsAboutTheCentroid() {
        Polygon square = Polygon.rectangle(1, 1, 3, 3);
        assertEquals(new Point(2, 2), square.centroid());
        assertEquals(4, square.signedArea());
        Polygon turned = square.at(new Pose(5, 6, Math.PI / 2));
        assertEquals(5, turned.centroid().x(), 1e-12);
        assertEquals(6, turned.x(0), 1e-12);
        assertEquals(5, turned.y(0), 1e-12);
        assertEquals(square, square.at(new Pose(2, 2, 0)));
    }

    @Test
    void overlapMeansSharedArea() {
        Polygon square = Polygon.rectangle(0, 0, 2, 2);
        assertTrue(Overlap.of(square, square));
        assertTrue(Overlap.of(square, Polygon.rectangle(0.5, 0.5, 1, 1)));
        assertTrue(Overlap.of(Polygon.rectangle(0.5, 0.5, 1, 1), square));
        assertTrue(Overlap.of(square, Polygon.rectangle(1, -1, 1.5, 3)));
        assertTrue(Overlap.of(square, Polygon.of(0, 0, 2, 0, 1, 1)));
        assertEquals(false, Overlap.of(square, Polygon.rectangle(2, 0, 3, 2)));
        assertEquals(false, Overlap.of(square, Polygon.rectangle(2, 2, 3, 3)));
        assertEquals(false, Overlap.of(square, Polygon.rectangle(2, 0.5, 3, 1)));
        assertEquals(false, Overlap.of(Polygon.of(0, 0, 4, 0, 4, 4, 3, 4, 3, 1, 0, 1), Polygon.rectangle(0, 1, 3, 4)));
    }
}
