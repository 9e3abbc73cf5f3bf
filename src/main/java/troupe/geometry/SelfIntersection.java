package troupe.geometry;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;

/** Finds where the outline of a polygon meets itself; exact for all finite corners. */
public final class SelfIntersection {
    private SelfIntersection() {}

    /** Two edges that meet where they must not; edge {@code i} runs from corner {@code i} to the next. */
    public record Edges(int first, int second) {}

    /**
     * Finds two edges that share a point other than the corner between neighbours, a zero-length edge
     * (reported with itself) or a spike. Sweeps over x with a list of open edges: O(n log n + k n') for
     * {@code n'} edges over the same x.
     */
    public static Optional<Edges> find(Polygon polygon) {
        int n = polygon.size();
        Integer[] order = new Integer[n];
        Arrays.setAll(order, i -> i);
        Arrays.sort(
                order,
                Comparator.comparingDouble((Integer i) -> minX(polygon, i)).thenComparing(i -> i));
        int[] open = new int[n];
        int count = 0;
        for (int next : order) {
            int kept = 0;
            for (int k = 0; k < count; k++) {
                int other = open[k];
                if (maxX(polygon, other) < minX(polygon, next)) {
                    continue;
                }
                open[kept++] = other;
                if (collide(polygon, Math.min(other, next), Math.max(other, next))) {
                    return Optional.of(new Edges(Math.min(other, next), Math.max(other, next)));
                }
            }
            count = kept;
            open[count++] = next;
            int after = (next + 1) % n;
            if (polygon.x(next) == polygon.x(after) && polygon.y(next) == polygon.y(after)) {
                return Optional.of(new Edges(next, next));
            }
        }
        return Optional.empty();
    }

    private static double minX(Polygon p, int edge) {
        return Math.min(p.x(edge), p.x((edge + 1) % p.size()));
    }

    private static double maxX(Polygon p, int edge) {
        return Math.max(p.x(edge), p.x((edge + 1) % p.size()));
    }

    private static boolean collide(Polygon p, int i, int j) {
        int n = p.size();
        int i1 = (i + 1) % n;
        int j1 = (j + 1) % n;
        if (i1 == j && j1 == i) {
            return true;
        }
        if (i1 == j) {
            return spike(p, i, j, j1);
        }
        if (j1 == i) {
            return spike(p, j, i, i1);
        }
        return Segments.meet(p.x(i), p.y(i), p.x(i1), p.y(i1), p.x(j), p.y(j), p.x(j1), p.y(j1));
    }

    /** Tells whether edges {@code a-b} and {@code b-c} run back over each other. */
    private static boolean spike(Polygon p, int a, int b, int c) {
        if (Orientation.sign(p.x(a), p.y(a), p.x(b), p.y(b), p.x(c), p.y(c)) != 0) {
            return false;
        }
        double forward = (p.x(b) - p.x(a)) * (p.x(c) - p.x(b)) + (p.y(b) - p.y(a)) * (p.y(c) - p.y(b));
        return forward < 0;
    }
}
