package troupe.geometry;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;

/** Finds where the outline of a polygon meets itself; exact for all finite corners. */
public final class SelfIntersection {
    private SelfIntersection() {}

    /** Two edges that meet where they must not; edge {@code i} runs from corner {@code i} to the next. */
    public record Edges(int first, int second) {}

    /** Counts down the pairs of edges that may still be compared; shared by any number of outlines. */
    public static final class Work {
        private long left;

        /** Allows a number of pairs. */
        public Work(long pairs) {
            this.left = pairs;
        }

        /** Tells whether nothing is left, so that an outline in which nothing was found may still meet itself. */
        public boolean isSpent() {
            return left <= 0;
        }
    }

    /** Does {@link #find(Polygon, Work)} however long it takes. */
    public static Optional<Edges> find(Polygon polygon) {
        return find(polygon, new Work(Long.MAX_VALUE));
    }

    /**
     * Finds two edges that share a point other than the corner between neighbours, a zero-length edge
     * (reported with itself) or a spike; gives up when the work is spent. Sweeps over the axis along which
     * the edges are shorter, with a list of open edges: O(n log n + pairs) for the pairs of edges over the
     * same stretch of that axis.
     */
    public static Optional<Edges> find(Polygon polygon, Work work) {
        int n = polygon.size();
        double[] from = new double[n];
        double[] to = new double[n];
        project(polygon, from, to);
        Integer[] order = new Integer[n];
        Arrays.setAll(order, i -> i);
        Arrays.sort(order, Comparator.comparingDouble((Integer i) -> from[i]).thenComparing(i -> i));
        int[] open = new int[n];
        int count = 0;
        for (int next : order) {
            int kept = 0;
            work.left -= count + 1;
            if (work.isSpent()) {
                return Optional.empty();
            }
            for (int k = 0; k < count; k++) {
                int other = open[k];
                if (to[other] < from[next]) {
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

    /** Fills in where each edge begins and ends along the axis on which they are shorter against the whole. */
    private static void project(Polygon polygon, double[] from, double[] to) {
        double alongX = 0;
        double alongY = 0;
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            alongX += Math.abs(polygon.x(i) - polygon.x(j));
            alongY += Math.abs(polygon.y(i) - polygon.y(j));
        }
        Box box = polygon.bounds();
        boolean overX = alongX * (box.maxY() - box.minY()) <= alongY * (box.maxX() - box.minX());
        for (int i = 0; i < polygon.size(); i++) {
            int after = (i + 1) % polygon.size();
            double a = overX ? polygon.x(i) : polygon.y(i);
            double b = overX ? polygon.x(after) : polygon.y(after);
            from[i] = Math.min(a, b);
            to[i] = Math.max(a, b);
        }
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
