package troupe.unified.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Obstacle;

/**
 * Holds which configurations are open while every movable obstacle stands where it is said to, or nowhere, and
 * the legal steps between them: built whole, cell by cell, from the definitions.
 */
final class Space {
    static final int[] DX = {1, 0, -1, 0, 1, -1, -1, 1};
    static final int[] DY = {0, 1, 0, -1, 1, 1, -1, -1};

    /** One legal step. */
    record Step(int direction, int to) {}

    final Ground ground;
    final Polygon[] outlines;
    final int[] abilities;
    private final Step[][] steps;

    /**
     * Builds a space.
     *
     * @param outlines where each obstacle of the scene stands; null for those that cannot move, and for those
     *     that are left out
     */
    Space(Ground ground, Polygon[] outlines) {
        this(ground, outlines, true);
        addCrossings();
    }

    private Space(Ground ground, Polygon[] outlines, boolean bare) {
        this.ground = ground;
        this.outlines = outlines;
        abilities = new int[ground.size];
        steps = new Step[ground.size][];
        for (int q = 0; q < ground.spanCount; q++) {
            abilities[q] = standing(ground, outlines, q);
        }
    }

    /** Builds the space that bounds all others from below: nothing movable, and vaults wherever one might be. */
    static Space widest(Ground ground, Polygon[] none, boolean relaxed) {
        if (!relaxed) {
            return new Space(ground, none);
        }
        Space space = new Space(ground, none, true);
        space.addGaps();
        new WidestVaults(space).add();
        return space;
    }

    /** Returns the abilities with which one can stand on a span while movable obstacles stand as said. */
    static int standing(Ground ground, Polygon[] outlines, int q) {
        int open = ground.room[q];
        for (int n = 0; n < outlines.length && open != 0; n++) {
            if (outlines[n] == null || !ground.inWay(ground.scene.obstacles().get(n), ground.floor[q])) {
                continue;
            }
            int at = q % ground.cells;
            if ((open & Ground.WALK) != 0
                    && ground.near(outlines[n], at, ground.actor.walk().radius())) {
                open &= ~Ground.WALK;
            }
            if ((open & Ground.SIDESTEP) != 0
                    && ground.near(
                            outlines[n],
                            at,
                            ground.actor.sidestep().orElseThrow().radius())) {
                open &= ~Ground.SIDESTEP;
            }
        }
        return open;
    }

    boolean open(int q) {
        return abilities[q] != 0;
    }

    boolean isSpan(int q) {
        return q < ground.spanCount;
    }

    /** Tells whether one can take off from a configuration and land there. */
    boolean firm(int q) {
        return isSpan(q) && ground.kind[q] == Ground.STABLE && (abilities[q] & Ground.WALK) != 0;
    }

    /** Returns the span over a cell whose floor is within a step of an elevation, -1 if there is none. */
    int spanNear(int at, double elevation) {
        int near = -1;
        for (int q = at; q < ground.spanCount; q += ground.cells) {
            if (ground.kind[q] != Ground.ABSENT
                    && Math.abs(ground.floor[q] - elevation) <= ground.actor.stepHeight() + Ground.SAME) {
                near = q;
            }
        }
        return near;
    }

    private void addCrossings() {
        addGaps();
        ground.actor.vault().ifPresent(vault -> {
            for (int level = 0; level < ground.levels.length; level++) {
                boolean[] candidates = vaultable(level, vault);
                if (any(candidates)) {
                    clearThick(level, vault, candidates);
                    keepStraight(level, true, candidates, vault.reach());
                }
            }
        });
    }

    private static boolean any(boolean[] mask) {
        boolean any = false;
        for (boolean set : mask) {
            any |= set;
        }
        return any;
    }

    private void clearThick(int level, Actor.Vault vault, boolean[] candidates) {
        boolean[] barred = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            int q = spanNear(at, ground.levels[level]);
            barred[at] = candidates[at] || q < 0 || (abilities[q] & Ground.WALK) == 0;
        }
        boolean[] thick = Discs.opened(ground, barred, vault.reach() / 2);
        for (int at = 0; at < ground.cells; at++) {
            candidates[at] &= !thick[at];
        }
    }

    private void addGaps() {
        ground.actor.stride().ifPresent(stride -> {
            for (int level = 0; level < ground.levels.length; level++) {
                boolean[] unsupported = unsupported(level, stride);
                if (any(unsupported)) {
                    for (int at = 0; at < ground.cells; at++) {
                        unsupported[at] = unsupported[at] && headRoom(at, ground.levels[level]);
                    }
                    keepStraight(level, false, unsupported, stride.gait());
                }
            }
        });
    }

    /** Returns the cells without support near a level that a closing by the gait fills. */
    private boolean[] unsupported(int level, Actor.Stride stride) {
        boolean[] supported = new boolean[ground.cells];
        boolean[] missing = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            int q = spanNear(at, ground.levels[level]);
            supported[at] = q >= 0 && ground.kind[q] != Ground.DROP;
            missing[at] = !supported[at] && !ground.outside(ground.x(at), ground.y(at));
        }
        boolean[] closed = any(missing) ? Discs.closed(ground, supported, stride.gait() / 2) : missing;
        for (int at = 0; at < ground.cells; at++) {
            closed[at] &= !supported[at];
        }
        return closed;
    }

    private boolean headRoom(int at, double floor) {
        double radius = ground.actor.walk().radius();
        boolean free = !ground.nearEdge(at, radius)
                && ground.groundsWithinWalk(at).last() <= floor + ground.actor.stepHeight() + Ground.SAME;
        for (int n = 0; n < outlines.length; n++) {
            Polygon outline = outline(n);
            free = free
                    && (outline == null
                            || !ground.inWay(ground.scene.obstacles().get(n), floor)
                            || !isNear(n, at));
        }
        return free;
    }

    /** Returns where an obstacle stands, movable or not; null if it is left out. */
    Polygon outline(int n) {
        Obstacle o = ground.scene.obstacles().get(n);
        return o.movable() ? outlines[n] : o.outline();
    }

    /** Tells whether an obstacle that stands somewhere comes within the walk radius of a cell's centre. */
    private boolean isNear(int n, int at) {
        return outlines[n] == null
                ? ground.fixedNear(n, at)
                : ground.near(outlines[n], at, ground.actor.walk().radius());
    }

    private boolean[] vaultable(int level, Actor.Vault vault) {
        boolean[] vaultable = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            vaultable[at] = solidsInWay(at, ground.levels[level], vault) == 1;
        }
        return vaultable;
    }

    /** Returns 0 if no solid is in a body's way at a cell, 1 if a vault can take all of them, else 2. */
    int solidsInWay(int at, double floor, Actor.Vault vault) {
        double step = floor + ground.actor.stepHeight();
        double radius = ground.actor.walk().radius();
        List<double[]> solids = new ArrayList<>();
        for (int n = 0; n < outlines.length; n++) {
            Obstacle o = ground.scene.obstacles().get(n);
            if (outline(n) != null && isNear(n, at)) {
                solids.add(new double[] {o.offset(), o.top(), o.movable() ? floor : step});
            }
        }
        for (double g : ground.groundsWithinWalk(at)) {
            solids.add(new double[] {Double.NEGATIVE_INFINITY, g, step});
        }
        double top = Double.NEGATIVE_INFINITY;
        for (double[] s : solids) {
            if (Ground.meets(s[0], s[1], s[2], floor + ground.actor.bodyHeight())) {
                top = Math.max(top, s[1]);
            }
        }
        if (ground.nearEdge(at, radius)) {
            return 2;
        }
        double high = Math.max(floor + ground.actor.bodyHeight(), top + vault.bodyHeight());
        for (double[] s : solids) {
            boolean inRange = s[1] >= floor + vault.minHeight() - Ground.SAME
                    && s[1] <= floor + vault.maxHeight() + Ground.SAME
                    && s[1] > step + Ground.SAME;
            if (top > Double.NEGATIVE_INFINITY && Ground.meets(s[0], s[1], s[2], high) && !inRange) {
                return 2;
            }
        }
        return top > Double.NEGATIVE_INFINITY ? 1 : 0;
    }

    /** Opens the crossings that some straight crossing between two firm spans passes. */
    private void keepStraight(int level, boolean vault, boolean[] candidates, double limit) {
        for (int begin = 0; begin < ground.spanCount; begin++) {
            if (!firm(begin) || ground.levelOf[begin] != level) {
                continue;
            }
            for (int[] step : ground.within(limit)) {
                int at = ground.shifted(begin % ground.cells, step);
                int end = at < 0 ? -1 : spanNear(at, ground.levels[level]);
                if (end >= 0 && firm(end)) {
                    keep(level, vault, candidates, ground.between(begin % ground.cells, at));
                }
            }
        }
    }

    private void keep(int level, boolean vault, boolean[] candidates, int[] between) {
        boolean all = between.length > 0;
        for (int at : between) {
            all = all && candidates[at];
        }
        for (int i = 0; all && i < between.length; i++) {
            abilities[ground.crossing(between[i], level, vault)] = Ground.CROSS;
        }
    }

    /** Tells whether a straight crossing of one kind leads from one span to another. */
    boolean straight(int begin, int end, boolean vault) {
        double limit = vault
                ? ground.actor.vault().orElseThrow().reach()
                : ground.actor.stride().orElseThrow().gait();
        int from = begin % ground.cells;
        int to = end % ground.cells;
        double length = Math.hypot(ground.x(to) - ground.x(from), ground.y(to) - ground.y(from));
        boolean straight = firm(begin)
                && firm(end)
                && length <= limit + Ground.SAME
                && Math.abs(ground.floor[end] - ground.floor[begin]) <= ground.actor.stepHeight() + Ground.SAME
                && ground.between(from, to).length > 0;
        for (int at : straight ? ground.between(from, to) : new int[0]) {
            straight = straight && open(ground.crossing(at, ground.levelOf[begin], vault));
        }
        return straight;
    }

    /** Returns the open configurations over a cell, ascending. */
    List<Integer> over(int at) {
        List<Integer> over = new ArrayList<>();
        for (int q = at; q < ground.spanCount; q += ground.cells) {
            if (open(q)) {
                over.add(q);
            }
        }
        for (int k = 0; k < 2 * ground.levels.length; k++) {
            int q = ground.spanCount + at * 2 * ground.levels.length + k;
            if (open(q)) {
                over.add(q);
            }
        }
        return over;
    }

    private boolean joined(int a, int b) {
        if (!isSpan(a) && !isSpan(b)) {
            return ground.isVault(a) == ground.isVault(b) && ground.elevation(a) == ground.elevation(b);
        }
        double low = Math.min(ground.elevation(a), ground.elevation(b));
        double high = Math.max(ground.elevation(a), ground.elevation(b));
        if (high - low > ground.actor.stepHeight() + Ground.SAME) {
            return false;
        }
        return !isSpan(a)
                || !isSpan(b)
                || Math.min(ground.ceiling[a], ground.ceiling[b]) - high >= ground.actor.bodyHeight() - Ground.SAME;
    }

    /** Returns the legal steps from an open configuration by direction, then number. */
    Step[] steps(int q) {
        if (steps[q] == null) {
            List<Step> found = new ArrayList<>();
            for (int d = 0; d < 8 && open(q); d++) {
                for (int to : over(ground.cellOf(q) + DY[d] * ground.cols + DX[d])) {
                    if (joined(q, to) && (d < 4 || besides(q, to, d))) {
                        found.add(new Step(d, to));
                    }
                }
            }
            steps[q] = found.toArray(new Step[0]);
        }
        return steps[q];
    }

    private boolean besides(int q, int to, int d) {
        boolean spans = isSpan(q) && isSpan(to);
        for (int offset : new int[] {DX[d], DY[d] * ground.cols}) {
            boolean any = false;
            for (int middle : over(ground.cellOf(q) + offset)) {
                any |= (!spans || isSpan(middle)) && joined(q, middle) && joined(middle, to);
            }
            if (!any) {
                return false;
            }
        }
        return true;
    }

    /** Returns the span that a legal step leads to from a span in the direction of a cell, -1 if there is none. */
    int stepToSpan(int q, int at) {
        for (Step step : steps(q)) {
            if (isSpan(step.to()) && step.to() % ground.cells == at) {
                return step.to();
            }
        }
        return -1;
    }

    /** Returns the configurations where something can be done here that cannot be done in another space. */
    TreeSet<Integer> lostIn(Space other) {
        TreeSet<Integer> lost = new TreeSet<>();
        for (int q = 0; q < ground.size; q++) {
            if ((abilities[q] & ~other.abilities[q]) != 0) {
                lost.add(q);
            }
        }
        return lost;
    }

    /** Returns outlines like these with one obstacle somewhere else, or nowhere. */
    static Polygon[] with(Polygon[] outlines, int obstacle, Polygon there) {
        Polygon[] changed = Arrays.copyOf(outlines, outlines.length);
        changed[obstacle] = there;
        return changed;
    }
}
