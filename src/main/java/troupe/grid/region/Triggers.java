package troupe.grid.region;

import java.util.BitSet;
import troupe.geometry.Polygon;
import troupe.scene.Ability;

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
     * Finds the trigger points of an obstacle that stands in the actual region.
     *
     * @param actual the region of a search space
     * @param optimistic the region of that search space without the obstacles that can still be moved
     * @param obstacle its index among the obstacles of the scene
     * @throws IllegalArgumentException if there is no movable obstacle of that index, or it is not there
     */
    public static Triggers of(Region actual, Region optimistic, int obstacle) {
        Polygon outline = actual.outline(obstacle)
                .orElseThrow(() -> new IllegalArgumentException(
                        "obstacle " + obstacle + " is not there; needs one that stands in the actual region"));
        Region back = optimistic.with(obstacle, outline);
        double bottom = actual.obstacle(obstacle).offset();
        BitSet found = new BitSet();
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        for (int q = 0; q < optimistic.size(); q++) {
            if (!isTaken(back, optimistic, q)) {
                continue;
            }
            int n = optimistic.neighbours(q, targets, directions);
            for (int i = 0; i < n; i++) {
                if (isPoint(actual, targets[i], bottom)) {
                    found.set(targets[i]);
                }
            }
        }
        return new Triggers(found.stream().toArray());
    }

    /** Tells whether a configuration of a region has lost an ability in another one of the same builder. */
    private static boolean isTaken(Region other, Region region, int q) {
        return q < region.spanCount()
                ? (region.abilities(q) & ~other.abilities(q)) != 0
                : other.crossing(region.cell(q), region.level(q), region.kind(q)) < 0;
    }

    private static boolean isPoint(Region actual, int q, double bottom) {
        return q < actual.spanCount()
                && actual.kind(q) == Kind.STABLE
                && (actual.abilities(q) & Ability.WALK.bit()) != 0
                && actual.steps(actual.elevation(q), bottom);
    }

    /** Returns the configurations of the trigger points, all of them spans, ascending; a new array. */
    public int[] points() {
        return points.clone();
    }
}
