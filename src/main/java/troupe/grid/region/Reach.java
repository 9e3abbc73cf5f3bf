package troupe.grid.region;

import java.util.Arrays;
import java.util.BitSet;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.ground.WalkBar;
import troupe.scene.Ability;

/**
 * Holds what can be reached of a region from one configuration by legal steps, in any number and
 * with every counter ignored. Immutable.
 */
public final class Reach {
    private static final int STRAIGHT = 15;

    private final Region region;
    private final BitSet reached;
    private int count;

    private Reach(Region region) {
        this.region = region;
        this.reached = new BitSet(region.size());
    }

    /**
     * Floods a region from a configuration; nothing is reached from one that is not open. Cost O(reached).
     *
     * @throws IllegalArgumentException if there is no such configuration
     */
    public static Reach from(Region region, int start) {
        if (start < 0 || start >= region.size()) {
            throw new IllegalArgumentException("configuration " + start + "; needs one in [0, " + region.size() + ")");
        }
        Reach reach = new Reach(region);
        if (region.open(start)) {
            reach.flood(start, new BitSet());
        }
        return reach;
    }

    /**
     * Floods a region from a configuration until another one is reached: if it is, what is held may be a part of all that
     * can be reached, and every part of it reaches the other one; else it is all. Cost O(reached).
     *
     * @throws IllegalArgumentException if there is no such configuration
     */
    public static Reach until(Region region, int start, int goal) {
        if (start < 0 || start >= region.size()) {
            throw new IllegalArgumentException("configuration " + start + "; needs one in [0, " + region.size() + ")");
        }
        Reach reach = new Reach(region);
        if (region.open(start)) {
            BitSet goals = new BitSet();
            goals.set(goal);
            reach.flood(start, goals);
        }
        return reach;
    }

    /** Floods from an open configuration until one of some others is found; returns whether one was. */
    private boolean flood(int start, BitSet others) {
        int[] queue = new int[256];
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int[] offsets = region.frame().offsets();
        reached.set(start);
        queue[count++] = start;
        for (int head = 0; head < count; head++) {
            if (others.get(queue[head])) {
                return true;
            }
            if (region.plain(queue[head])) {
                if (count + GridFrame.DIRECTIONS > queue.length) {
                    queue = Arrays.copyOf(queue, 2 * queue.length);
                }
                for (int rest = region.moves(queue[head]) & STRAIGHT; rest != 0; rest &= rest - 1) {
                    int to = queue[head] + offsets[Integer.numberOfTrailingZeros(rest)];
                    if (!reached.get(to)) {
                        reached.set(to);
                        queue[count++] = to;
                    }
                }
                continue;
            }
            int n = region.beside(queue[head], targets, directions);
            if (count + n > queue.length) {
                queue = Arrays.copyOf(queue, 2 * queue.length + n);
            }
            for (int i = 0; i < n; i++) {
                if (!reached.get(targets[i])) {
                    reached.set(targets[i]);
                    queue[count++] = targets[i];
                }
            }
        }
        return false;
    }

    /**
     * Tells whether legal steps lead from a configuration to one of some others; so it is where it is one of
     * them itself. Ends with the first that is found. Cost O(reached).
     */
    public static boolean leads(Region region, int start, BitSet others) {
        Reach reach = new Reach(region);
        return region.open(start) && reach.flood(start, others);
    }

    /**
     * Tells whether, where a movable obstacle stands at an outline, one can stand and walk at a configuration, and
     * legal steps lead from there to one of some others. Looks first for a way that only walks, for which the region
     * with the obstacle need not be built. Cost O(reached).
     *
     * @param without the region without the obstacle
     * @param obstacle its index among the obstacles of the scene
     * @throws IllegalArgumentException if there is no movable obstacle of that index
     */
    public static boolean leads(Region without, int obstacle, Polygon outline, int start, BitSet others) {
        WalkBar bar = without.barred(obstacle, outline);
        return without.takesOff(start)
                && !bar.bars(start, without.cell(start))
                && (walks(without, bar, start, others) || leads(without.with(obstacle, outline), start, others));
    }

    /** Tells whether one can walk, on sheets and past what is barred, from a configuration to one of some others. */
    private static boolean walks(Region region, WalkBar bar, int start, BitSet others) {
        int[] offsets = region.frame().offsets();
        int[] queue = new int[256];
        BitSet seen = new BitSet(region.spanCount());
        seen.set(start);
        queue[0] = start;
        for (int head = 0, count = 1; head < count; head++) {
            int q = queue[head];
            if (others.get(q)) {
                return true;
            }
            int free = 0;
            for (int rest = region.moves(q); rest != 0; rest &= rest - 1) {
                int direction = Integer.numberOfTrailingZeros(rest);
                int to = q + offsets[direction];
                boolean walked = (region.abilities(to) & Ability.WALK.bit()) != 0 && !bar.bars(to, region.cell(to));
                free |= walked ? 1 << direction : 0;
            }
            if (count + GridFrame.DIRECTIONS > queue.length) {
                queue = Arrays.copyOf(queue, 2 * queue.length);
            }
            for (int rest = free & beside(free); rest != 0; rest &= rest - 1) {
                int to = q + offsets[Integer.numberOfTrailingZeros(rest)];
                if (!seen.get(to)) {
                    seen.set(to);
                    queue[count++] = to;
                }
            }
        }
        return false;
    }

    /** Returns the straight directions, and those diagonals between two straight ones that are both in a set. */
    private static int beside(int free) {
        int next = (free & 14) >> 1 | (free & 1) << 3;
        return 15 | (free & next) << 4;
    }

    /** Tells whether the configuration can be reached. */
    public boolean reached(int q) {
        return reached.get(q);
    }

    /** Returns how many configurations can be reached, the start included. */
    public int count() {
        return count;
    }
}
