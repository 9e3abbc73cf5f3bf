package troupe.crowd.ground;

import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.search.BucketQueue;

/**
 * Finds the potential to a goal in which a crowded or slow place costs more: the time that the way takes at the
 * speeds there, as a length at full speed. A cell of length l costs l times the slowness of its place, and a little
 * more beside walls, so that ways keep off them. Dijkstra over the legal steps. Not in the paper, which names it as
 * future work. Advances by expansions, so that the work can be spread over the steps of a crowd. Keeps its scratch; one
 * thread at a time. Cost O(spans log spans) for each potential.
 */
public final class Detours {
    private static final double UNITS = 1e4;
    private static final int SHIFT = 9;
    private static final double WALL_COST = 0.5;
    private static final double WALL_REACH = 0.6;

    private final Terrain terrain;
    private final GridFrame frame;
    private final long[] costs;
    private final float[] found;
    private final BucketQueue open;
    private final float[] wall;
    private Slowness slowness;

    /** Makes room for the spans of a terrain. */
    public Detours(Terrain terrain) {
        this.terrain = terrain;
        this.frame = terrain.region().frame();
        this.costs = new long[terrain.size()];
        this.found = new float[terrain.size()];
        this.open = new BucketQueue(SHIFT);
        this.wall = new float[terrain.size()];
        for (int q = 0; q < wall.length; q++) {
            double room = terrain.open(q) ? terrain.clearance(q) - terrain.radius() : 0;
            wall[q] = (float) (1 + WALL_COST * Math.max(0, 1 - room / WALL_REACH));
        }
    }

    /** Tells how many times longer a way takes at a place, at least 1. */
    @FunctionalInterface
    public interface Slowness {
        /** Returns the factor at a place in metres and elevation. */
        double at(double x, double y, double z);
    }

    /** Begins the potential to a goal; what was begun before is dropped. {@code slowness} must not change until it is done. */
    public void begin(int goal, Slowness slowness) {
        this.slowness = slowness;
        Arrays.fill(costs, Long.MAX_VALUE);
        open.clear();
        costs[goal] = 0;
        open.add(goal, 0, 0);
    }

    /** Goes on for at most so many expansions; tells whether it is done. */
    public boolean advance(long expansions) {
        for (long n = 0; n < expansions && !open.isEmpty(); n++) {
            long key = open.firstKey();
            int q = open.removeFirst();
            if (key == costs[q]) {
                expand(q, key);
            }
        }
        return open.isEmpty();
    }

    private void expand(int q, long key) {
        double factor =
                slowness.at(terrain.region().x(q), terrain.region().y(q), terrain.elevation(q)) * wall[q] * UNITS;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            int to = terrain.neighbour(q, d);
            if (to >= 0) {
                long cost = key + Math.max(1, Math.round(frame.stepLength(d) * factor));
                if (cost < costs[to]) {
                    costs[to] = cost;
                    open.add(to, cost, cost);
                }
            }
        }
    }

    /** Returns the number of spans: more than so many expansions are rarely needed. */
    public int size() {
        return costs.length;
    }

    /** Returns the potential that is done, in metres at full speed; the array is used again. Cost O(spans). */
    public float[] found() {
        for (int q = 0; q < found.length; q++) {
            found[q] = costs[q] == Long.MAX_VALUE ? Float.POSITIVE_INFINITY : (float) (costs[q] / UNITS);
        }
        return found;
    }
}
