package troupe.unified.cost;

import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.search.BestFirst;
import troupe.search.BucketQueue;
import troupe.search.Expander;
import troupe.search.Outcome;

/**
 * Finds the least cost from configurations to the goal when counters, and the straightness of crossings,
 * are left out: an admissible and consistent bound on what a label still has to pay. It searches
 * backwards from the goal towards the start and goes only as far as it is asked; it can be asked to go on.
 *
 * <p>Whatever is settled has its exact value. For the rest, the first open key {@code f} bounds it: the
 * backward search is A* with the octile distance from the start at the cheapest price, so what is not
 * settled costs at least {@code f} minus that distance.
 *
 * <p>Source: reverse resumable A* (Silver, Cooperative Pathfinding, 2005), over the moves of Unified
 * section 7. Cost of a whole search: O(n log b) for n configurations and b entries in a bucket.
 */
public final class CostToGo implements Expander {
    /** The bound of a configuration from which the goal cannot be reached. */
    public static final long UNREACHABLE = Long.MAX_VALUE / 4;

    private static final Outcome NOTHING_LEFT = new Outcome.Infeasible("everything that reaches the goal is settled");

    private static final int ANY = FieldMemory.ANY;
    private static final int STANDING = Ability.WALK.bit() | Ability.SIDESTEP.bit();
    private static final int NONE = -1;

    /** For each arrival, the directions in which a place must be left. */
    private static final int[] AHEAD = new int[ANY + 1];

    static {
        for (int side = 0; side < 4; side++) {
            int left = 1 << 4 + side;
            int right = 1 << 4 + (side + 3 & 3);
            AHEAD[side] = 1 << side | left | right;
            AHEAD[4 + side] = 1 << 4 + side | 1 << side | 1 << (side + 1 & 3);
        }
        AHEAD[ANY] = 255;
    }

    private final FieldMemory memory;
    private final Region region;
    private final JourneyCosts costs;
    private final BucketQueue open;
    private final BestFirst search;
    private final long[] toGo;
    private final int[] stamps;
    private final int[] offsets;
    private final boolean relaxed;
    private final long[] standing;
    private final int isOpen;
    private final int isSettled;
    private final int spans;
    private final int cols;
    private final int cells;
    private final int startCol;
    private final int startRow;
    private final long straight;
    private final long bend;

    private int wanted;
    private long wantedFrontier;
    private long frontier;

    /** Configurations that are to be settled with all that ties with them, how many are, and their greatest key. */
    private int[] exact = {};

    private int exactCount;
    private long exactKey;

    /**
     * Makes a search towards a configuration that has settled nothing yet, and is asked for nothing.
     *
     * @param memory the memory of the region; an earlier search that used it is void
     * @param towards near where the cost to go will be asked for first
     * @param ends where ways end, and what each end costs besides
     */
    public CostToGo(FieldMemory memory, JourneyCosts costs, int towards, Ends ends) {
        this.memory = memory;
        this.region = memory.region;
        this.costs = costs;
        int generation = memory.begin(costs);
        this.open = memory.open();
        toGo = memory.toGo;
        stamps = memory.stamps;
        offsets = memory.offsets;
        relaxed = memory.relaxed;
        standing = costs.cheapestTable(relaxed && costs.has(Ability.VAULT));
        isOpen = FieldMemory.STAMPS * generation;
        isSettled = isOpen + FieldMemory.SETTLED;
        spans = region.spanCount();
        GridFrame frame = region.frame();
        cols = frame.cols();
        cells = frame.size();
        int startCell = region.cell(towards);
        startCol = frame.col(startCell);
        startRow = frame.row(startCell);
        straight = costs.cheapestStraight();
        bend = costs.cheapestDiagonal() - straight;
        search = new BestFirst(open, this, NOTHING_LEFT, Long.MAX_VALUE);
        wanted = towards;
        for (int i = 0; i < ends.places().length; i++) {
            reach(ends.places()[i], ends.costs()[i]);
        }
        frontier = open.isEmpty() ? UNREACHABLE : open.firstKey();
    }

    /**
     * Says where ways end.
     *
     * @param places configurations
     * @param costs what each costs in units, from 0
     */
    public record Ends(int[] places, long[] costs) {
        /** Returns that ways end at a goal, which costs nothing. */
        public static Ends at(int goal) {
            return new Ends(new int[] {goal}, new long[1]);
        }
    }

    /** Tells whether the cost to go from a configuration is known exactly. */
    boolean isSettled(int configuration) {
        return stamps[configuration] == isSettled || !search.outcome().isRunning();
    }

    /** Returns a bound on the cost to go in units: exact if settled, {@link #UNREACHABLE} if there is no way. */
    public long bound(int configuration) {
        if (stamps[configuration] == isSettled) {
            return toGo[configuration];
        }
        if (!search.outcome().isRunning()) {
            return UNREACHABLE;
        }
        return Math.max(0, frontier - fromStart(configuration));
    }

    /** Asks for a configuration to be settled, or for its bound to rise to at least {@code bound}. */
    public void want(int configuration, long bound) {
        wanted = configuration;
        wantedFrontier = bound + fromStart(configuration);
    }

    /**
     * Asks for configurations to be settled so far that every way of least cost from them is: no open place can
     * come before them any more. Whether it is so is told by {@link #isExact}.
     */
    public void wantExact(int[] configurations) {
        exact = configurations;
        exactCount = 0;
        exactKey = -1;
    }

    /** Tells whether what {@link #wantExact} asked for is there, or will never be. */
    public boolean isExact() {
        while (exactCount < exact.length && stamps[exact[exactCount]] == isSettled) {
            exactKey = Math.max(exactKey, toGo[exact[exactCount]] + fromStart(exact[exactCount]));
            exactCount++;
        }
        return exactCount == exact.length && frontier > exactKey
                || !search.outcome().isRunning();
    }

    private boolean isWanting() {
        return !isExact() || stamps[wanted] != isSettled && frontier < wantedFrontier;
    }

    /**
     * Tells whether what was asked for is there, or will never be. The search has then looked at the next
     * open place, too, so that what it knows does not depend on how the work was sliced.
     */
    public boolean hasAnswered() {
        return search.isWaiting() || !search.outcome().isRunning();
    }

    /** Works towards what was asked for, with at most {@code budget} expansions; returns those made. */
    public long advance(long budget) {
        long before = search.expanded();
        search.step(budget);
        return search.expanded() - before;
    }

    /** Returns the expansions so far. */
    public long expanded() {
        return search.expanded();
    }

    @Override
    public Verdict expand(int item, long key) {
        frontier = key;
        if (stamps[item] == isSettled) {
            return Verdict.SKIPPED;
        }
        if (!isWanting()) {
            open.add(item, key, toGo[item]);
            return Verdict.WAITING;
        }
        int arrival = stamps[item] - isOpen;
        stamps[item] = isSettled;
        int here = memory.local(item);
        if ((here & FieldMemory.PLAIN) != 0) {
            expandPlain(item, here, arrival);
        } else {
            expandLinked(item);
        }
        return Verdict.EXPANDED;
    }

    /**
     * Expands a place whose legal steps all lie on its own sheet. It leaves out the neighbours that the
     * place it was reached from reaches more cheaply by itself: on a way of least cost they never follow.
     */
    private void expandPlain(int to, int here, int arrival) {
        int[] stamps = this.stamps;
        int cell = to < cells ? to : to % cells;
        int row = cell / cols;
        int col = cell - row * cols;
        int abilities = here >> FieldMemory.ABILITIES & STANDING;
        long cost = toGo[to];
        boolean calm = (here & FieldMemory.CALM) != 0;
        for (int rest = here & AHEAD[arrival]; rest != 0; rest &= rest - 1) {
            int direction = Integer.numberOfTrailingZeros(rest);
            int from = to + offsets[direction];
            int stamp = stamps[from];
            if (stamp != isSettled) {
                int common = calm ? abilities : abilities & memory.abilities(from);
                long next = cost + standing[common << 1 | direction >> 2];
                if (next < JourneyCosts.BLOCKED && (stamp < isOpen || next < toGo[from])) {
                    stamps[from] = isOpen + (calm ? direction : ANY);
                    toGo[from] = next;
                    open.add(
                            from, next + fromStart(col + GridFrame.dx(direction), row + GridFrame.dy(direction)), next);
                }
            }
        }
    }

    private void expandLinked(int to) {
        int count = region.neighbours(to, memory.targets, memory.directions);
        for (int i = 0; i < count; i++) {
            int from = memory.targets[i];
            long step = step(from, to, memory.directions[i]);
            if (stamps[from] != isSettled && step < JourneyCosts.BLOCKED && !isIdle(from, toGo[to] + step)) {
                reach(from, toGo[to] + step);
            }
        }
    }

    /** Tells whether a vault need not be gone on with at some cost, because walking there is known to cost no more. */
    private boolean isIdle(int configuration, long cost) {
        if (!relaxed || configuration < spans || region.kind(configuration) != Kind.JUMPABLE) {
            return false;
        }
        int beneath = region.standing(region.cell(configuration), region.elevation(configuration));
        return beneath >= 0 && memory.isIdle(beneath) && stamps[beneath] >= isOpen && toGo[beneath] <= cost;
    }

    private void reach(int configuration, long cost) {
        if (cost >= JourneyCosts.BLOCKED || stamps[configuration] >= isOpen && toGo[configuration] <= cost) {
            return;
        }
        stamps[configuration] = isOpen + ANY;
        toGo[configuration] = cost;
        open.add(configuration, cost + fromStart(configuration), cost);
    }

    /**
     * Returns the next place on a way of least cost to the goal: of the neighbours from which the rest costs
     * the difference, the one of least direction, then number; -1 at the goal and where there is none. The
     * configuration must be exact. Cost O(neighbours).
     */
    int next(int from) {
        if (stamps[from] != isSettled) {
            return NONE;
        }
        int count = region.neighbours(from, memory.targets, memory.directions);
        for (int i = 0; i < count; i++) {
            int to = memory.targets[i];
            if (stamps[to] == isSettled) {
                long step = step(from, to, memory.directions[i]);
                if (step < JourneyCosts.BLOCKED && step + toGo[to] == toGo[from]) {
                    return to;
                }
            }
        }
        return NONE;
    }

    private long fromStart(int configuration) {
        int cell = region.cell(configuration);
        return fromStart(cell % cols, cell / cols);
    }

    private long fromStart(int col, int row) {
        int dx = Math.abs(col - startCol);
        int dy = Math.abs(row - startRow);
        return straight * Math.max(dx, dy) + bend * Math.min(dx, dy);
    }

    /** Returns the cost in units of a step between neighbours, take-off included, or at least {@code BLOCKED}. */
    private long step(int from, int to, int direction) {
        boolean enters = to >= spans;
        if (from >= spans) {
            byte kind = region.kind(from);
            boolean lands = enters || region.takesOff(to);
            return lands ? costs.crossing(kind, direction) : JourneyCosts.BLOCKED;
        }
        if (enters) {
            byte kind = region.kind(to);
            boolean takesOff = region.takesOff(from) && region.elevation(from) == region.elevation(to);
            return takesOff ? costs.crossing(kind, direction) + costs.takeOffUnits(kind) : JourneyCosts.BLOCKED;
        }
        return standing[(region.abilities(from) & region.abilities(to) & STANDING) << 1 | direction >> 2];
    }
}
