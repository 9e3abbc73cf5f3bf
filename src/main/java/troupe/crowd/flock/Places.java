package troupe.crowd.flock;

import java.util.Arrays;
import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;
import troupe.grid.GridFrame;

/**
 * Hands out the places around a goal to those who come to it: on the side from which one comes, the free one with the
 * least depth, which is how far it lies before the goal and {@value #SLOPE} of how far aside. So the ground fills from
 * the goal outwards behind a blunt wedge, each face of which can be seen from before its tip: nobody's place lies behind
 * others who stand already, as it would behind a half circle. The places lie on a triangular lattice, {@value #PITCH}
 * radii apart, twice as many as there are agents. One thread at a time.
 */
public final class Places {
    /** The bodies cover half of the ground. */
    private static final double PITCH = 2.7;

    /** The depth of a place for each metre that it lies aside. */
    private static final double SLOPE = 0.7;

    private final Way way;
    private final int[] spans;
    private final double[] placeX;
    private final double[] placeY;
    private final boolean[] taken;
    private int first;
    private double outermost;

    /**
     * Lays out the places around the goal of a way.
     *
     * @param radius the largest of those who come, in metres
     * @param reach the potential in metres within which they lie
     */
    Places(Way way, double radius, double reach) {
        this.way = way;
        Terrain terrain = way.terrain();
        GridFrame frame = terrain.region().frame();
        double pitch = PITCH * radius;
        double height = pitch * Math.sqrt(0.75);
        int[] ground = way.around(reach);
        double goalX = terrain.region().x(way.goal());
        double goalY = terrain.region().y(way.goal());
        long[] keys = new long[ground.length];
        int count = 0;
        for (int q : ground) {
            double x = terrain.region().x(q) - goalX;
            double y = terrain.region().y(q) - goalY;
            long row = Math.round(y / height);
            double shift = (row & 1) * 0.5;
            double latticeX = (Math.round(x / pitch - shift) + shift) * pitch;
            if (frame.colAt(goalX + latticeX) == frame.colAt(goalX + x)
                    && frame.rowAt(goalY + row * height) == frame.rowAt(goalY + y)) {
                // potentials are not negative: their bits sort as they do
                keys[count++] = (long) Float.floatToRawIntBits(way.potential(q)) << 32 | q;
            }
        }
        Arrays.sort(keys, 0, count);
        spans = Arrays.stream(keys, 0, count).mapToInt(key -> (int) key).toArray();
        taken = new boolean[count];
        placeX = new double[count];
        placeY = new double[count];
        for (int p = 0; p < count; p++) {
            placeX[p] = terrain.region().x(spans[p]);
            placeY[p] = terrain.region().y(spans[p]);
        }
    }

    /**
     * Returns the number of the place that somebody at {@code (x, y)} metres would get, -1 if there is none. Cost
     * O(places that are not known to be taken).
     */
    int next(double x, double y) {
        Terrain terrain = way.terrain();
        double goalX = terrain.region().x(way.goal());
        double goalY = terrain.region().y(way.goal());
        double length = Math.max(1e-9, Math.sqrt((x - goalX) * (x - goalX) + (y - goalY) * (y - goalY)));
        double towardsX = (x - goalX) / length;
        double towardsY = (y - goalY) / length;
        while (first < taken.length && taken[first]) {
            first++;
        }
        int best = first < taken.length ? first : -1;
        double least = Double.POSITIVE_INFINITY;
        for (int p = first; p < spans.length; p++) {
            if (!taken[p]) {
                double along = (placeX[p] - goalX) * towardsX + (placeY[p] - goalY) * towardsY;
                double across = (placeX[p] - goalX) * towardsY - (placeY[p] - goalY) * towardsX;
                double depth = along + SLOPE * Math.abs(across);
                if (along >= -1e-9 && depth < least) {
                    least = depth;
                    best = p;
                }
            }
        }
        return best;
    }

    /** Returns the span of a place. */
    int span(int p) {
        return spans[p];
    }

    /** Takes a place. */
    void take(int p) {
        taken[p] = true;
        outermost = Math.max(outermost, way.potential(spans[p]));
    }

    /** Returns the potential in metres of the place farthest out that is taken, 0 before the first. */
    double outermost() {
        return outermost;
    }
}
