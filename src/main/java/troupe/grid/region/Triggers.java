package troupe.grid.region;

import java.util.BitSet;
import troupe.grid.GridFrame;
import troupe.grid.Window;

/**
 * Finds the trigger points of a movable obstacle: where an actor can stand on stable ground beside what the
 * obstacle takes from it. A configuration is taken if some ability can be used there in the optimistic region, in
 * which whatever can be moved is not there, and not in that region with the obstacle put back; crossings are the
 * same if cell, take-off level and kind are. (Were only what is shut altogether taken, then no place to walk on
 * would lie next to it, where a band for sidesteps as broad as a cell goes round the obstacle.) A trigger point is a stable span of the actual region on which one can
 * walk, whose floor lies within a step of the obstacle's bottom, with a legal step of the optimistic region to
 * something taken. Whether the obstacle is supported, or may be moved at all, is not asked. Immutable.
 *
 * <p>Source: Unified sections 6.1 and 6.3. Deviation: the paper puts the points on the edge of the C-obstacle
 * itself.
 */
public final class Triggers {
    private final int[] points;

    private Triggers(int[] points) {
        this.points = points;
    }

    /**
     * Finds the trigger points of an obstacle in a part of the world.
     *
     * @param actual the region of a search space, in which the obstacle stands
     * @param optimistic a region that is the optimistic one in {@code near}
     * @param back a region that is the optimistic one with the obstacle put back, in {@code near}
     * @param obstacle its index among the obstacles of the scene
     * @param near the cells where the two can differ, and one more on each side
     */
    public static Triggers of(Region actual, Region optimistic, Region back, int obstacle, Window near) {
        double bottom = actual.obstacle(obstacle).offset();
        GridFrame frame = actual.frame();
        BitSet found = new BitSet();
        for (int row = near.row0(); row < near.row0() + near.rows(); row++) {
            int first = frame.index(near.col0(), row);
            for (int base = first; base < optimistic.spanCount(); base += frame.size()) {
                for (int q = base; q < base + near.cols(); q++) {
                    if (isTaken(back, optimistic, q)) {
                        addPoints(actual, optimistic, q, bottom, found);
                    }
                }
            }
        }
        for (int q = optimistic.spanCount(); q < optimistic.size(); q++) {
            int cell = optimistic.cell(q);
            if (near.holds(frame.col(cell), frame.row(cell)) && isTaken(back, optimistic, q)) {
                addPoints(actual, optimistic, q, bottom, found);
            }
        }
        return new Triggers(found.stream().toArray());
    }

    private static void addPoints(Region actual, Region optimistic, int taken, double bottom, BitSet found) {
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int n = optimistic.neighbours(taken, targets, directions);
        for (int i = 0; i < n; i++) {
            if (isPoint(actual, targets[i], bottom)) {
                found.set(targets[i]);
            }
        }
    }

    /** Tells whether a configuration of a region has lost an ability in another one of the same builder. */
    private static boolean isTaken(Region other, Region region, int q) {
        return q < region.spanCount()
                ? (region.abilities(q) & ~other.abilities(q)) != 0
                : other.crossing(region.cell(q), region.level(q), region.kind(q)) < 0;
    }

    private static boolean isPoint(Region actual, int q, double bottom) {
        return actual.takesOff(q) && actual.steps(actual.elevation(q), bottom);
    }

    /** Returns the configurations of the trigger points, all of them spans, ascending; a new array. */
    public int[] points() {
        return points.clone();
    }
}
