package troupe.grid.region;

import java.util.Arrays;
import java.util.BitSet;

/**
 * Holds the part of a region that can be reached from one configuration by legal steps, in any number and
 * with every counter ignored. Immutable.
 */
public final class Reach {
    private final Region region;
    private final BitSet reached = new BitSet();
    private int count;

    private Reach(Region region) {
        this.region = region;
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

    /** Floods from an open configuration until one of some others is found; returns whether one was. */
    private boolean flood(int start, BitSet others) {
        int[] queue = new int[256];
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        reached.set(start);
        queue[count++] = start;
        for (int head = 0; head < count; head++) {
            if (others.get(queue[head])) {
                return true;
            }
            int n = region.neighbours(queue[head], targets, directions);
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

    /** Tells whether the configuration can be reached. */
    public boolean reached(int q) {
        return reached.get(q);
    }

    /** Returns how many configurations can be reached, the start included. */
    public int count() {
        return count;
    }
}
