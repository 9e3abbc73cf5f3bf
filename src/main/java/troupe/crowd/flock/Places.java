package troupe.crowd.flock;

import java.util.Arrays;
import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;
import troupe.grid.GridFrame;

/**
 * Hands out the places around a goal to those who come to it: the nearest to the goal that is free, on the side from
 * which one comes. So the ground fills from the goal outwards, and nobody stands in the way of the next. The places
 * lie on a triangular lattice, {@value #PITCH} radii apart, twice as many as there are agents. One thread at a time.
 */
public final class Places {
    /** The bodies cover half of the ground. */
    private static final double PITCH = 2.7;

    private final Way way;
    private final int[] spans;
    private final boolean[] taken;
    private int first;

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
    }

    /** Returns the number of the place that somebody at {@code (x, y)} metres would get, -1 if there is none. */
    int next(double x, double y) {
        Terrain terrain = way.terrain();
        double towardsX = x - terrain.region().x(way.goal());
        double towardsY = y - terrain.region().y(way.goal());
        while (first < taken.length && taken[first]) {
            first++;
        }
        for (int p = first; p < spans.length; p++) {
            double dx = terrain.region().x(spans[p]) - terrain.region().x(way.goal());
            double dy = terrain.region().y(spans[p]) - terrain.region().y(way.goal());
            if (!taken[p] && dx * towardsX + dy * towardsY >= 0) {
                return p;
            }
        }
        return first < taken.length ? first : -1;
    }

    /** Returns the span of a place. */
    int span(int p) {
        return spans[p];
    }

    /** Takes a place. */
    void take(int p) {
        taken[p] = true;
    }
}
