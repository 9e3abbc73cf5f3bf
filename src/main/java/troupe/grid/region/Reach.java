package troupe.grid.region;

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
            reach.flood(start);
        }
        return reach;
    }

    private void flood(int start) {
        int[] queue = new int[region.size()];
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        reached.set(start);
        queue[count++] = start;
        for (int head = 0; head < count; head++) {
            int n = region.neighbours(queue[head], targets, directions);
            for (int i = 0; i < n; i++) {
                if (!reached.get(targets[i])) {
                    reached.set(targets[i]);
                    queue[count++] = targets[i];
                }
            }
        }
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
