package troupe.risk.plan;

import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.risk.forecast.Forecast;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.search.BestFirst;
import troupe.search.Expander;
import troupe.search.LabelPool;
import troupe.search.MinHeap;
import troupe.search.Outcome;

/**
 * Searches a way in place and time, best first: {@code Uncertain_BFP} of Avatars, figure 5. A state is a
 * configuration and a time in ticks of {@link Ground#tick}: straight moves take 5, diagonal ones 7, a wait 5.
 *
 * <p>With the paper's ordering the next state is the one of least potential plus risk, potentials in metres, and
 * the first state at the goal ends the search. With the optimal ordering it is the one of least way so far, plus
 * caution times the risk gathered, plus the shortest way to go; a wait counts like the way that it could have been,
 * and of times less than a straight move apart only the best is kept.
 *
 * <p>Deviations: waiting; beyond the horizon time no longer distinguishes states, as nothing is predicted there.
 * Used by one thread at a time; it keeps its memory from one search to the next.
 */
public final class TimeSearch implements Expander {
    private static final double MICRO = 1e6;
    private static final Outcome NO_WAY = new Outcome.Infeasible("no way among the avatars");
    /** Keeps a key whole and small, whatever the risk. */
    private static final double MOST_RISK = 1e9;

    private static final double TIE = 1e-3;

    private final Ground ground;
    private final Region region;
    private final GridFrame frame;
    private final Forecast forecast;
    private final Hazards hazards;
    private final boolean optimal;
    private final double caution;
    private final double tick;
    private final int lastTick;
    private final long limit;
    private final int[] targets = new int[Region.MAX_NEIGHBOURS + 1];
    private final int[] directions = new int[Region.MAX_NEIGHBOURS + 1];
    private final LabelPool labels = new LabelPool(1 << 12);
    private final StateTable states = new StateTable();
    private final MinHeap open = new MinHeap();
    private double startX;
    private double startY;
    private int goalLabel;
    private long expanded;

    /**
     * Makes a search.
     *
     * @param encounter whose method {@code STATIC} searches in space alone, as if nothing ever changed
     * @param limit the most expansions, at least 1
     */
    public TimeSearch(Ground ground, Encounter encounter, Forecast forecast, Hazards hazards, long limit) {
        this.ground = ground;
        this.region = ground.region();
        this.frame = region.frame();
        this.forecast = forecast;
        this.hazards = hazards;
        boolean timeless = encounter.method() == Encounter.Method.STATIC;
        this.optimal = timeless || encounter.ordering() == Encounter.Order.OPTIMAL;
        this.caution = encounter.number(Quantity.CAUTION);
        this.tick = ground.tick();
        this.lastTick = timeless ? 0 : (int) Math.ceil(encounter.number(Quantity.HORIZON) / tick);
        this.limit = limit;
    }

    /**
     * Searches a way from a place, from now on.
     *
     * @param q the configuration of the place
     * @param now the time of the path's first point in seconds
     * @param path receives the way if there is one; else it stays as it is
     */
    public Outcome search(double x, double y, int q, double now, TimedPath path) {
        labels.clear();
        states.clear();
        open.clear();
        startX = x;
        startY = y;
        expanded = 0;
        if (!ground.leads(q)) {
            return NO_WAY;
        }
        add(q, LabelPool.NONE, 0, 0);
        BestFirst loop = new BestFirst(open, this, NO_WAY, limit);
        while (loop.step(Long.MAX_VALUE).isRunning()) {
            // one slice does
        }
        expanded = loop.expanded();
        if (loop.outcome().isFound()) {
            trace(now, path);
        }
        return loop.outcome();
    }

    /** Returns the expansions of the last search. */
    public long expanded() {
        return expanded;
    }

    private long state(int q, long ticks) {
        long time = Math.min(ticks, lastTick);
        return optimal
                ? (long) q * (lastTick / Ground.WAIT + 1) + time / Ground.WAIT
                : (long) q * (lastTick + 1) + time;
    }

    private void add(int q, int parent, long ticks, double risk) {
        long state = state(q, ticks);
        int known = states.get(state);
        long key;
        long cost;
        if (optimal) {
            cost = Math.round(MICRO * (ticks * tick * ground.speed() + Math.min(risk, MOST_RISK)));
            if (known != StateTable.NONE && labels.cost(known) <= cost) {
                return;
            }
            key = cost + Math.round(MICRO * ground.ticksToGo(q) * tick * ground.speed());
        } else {
            if (known != StateTable.NONE) {
                return;
            }
            cost = ticks;
            // of equal potentials the shorter way: NF1 alone does not tell a diagonal from a straight move
            double tie = TIE * ground.ticksToGo(q) * tick * ground.speed();
            key = Math.round(MICRO * (ground.potential(q) + Math.min(risk, MOST_RISK) + tie));
        }
        int label = labels.add((int) ticks, q, parent, cost, risk, LabelPool.NONE, LabelPool.NONE);
        states.put(state, label);
        open.add(label, key, cost);
    }

    @Override
    public Verdict expand(int label, long key) {
        int q = labels.state(label);
        long ticks = labels.space(label);
        if (optimal && states.get(state(q, ticks)) != label) {
            return Verdict.SKIPPED;
        }
        if (q == ground.goal()) {
            goalLabel = label;
            return Verdict.GOAL;
        }
        int count = region.neighbours(q, targets, directions);
        for (int k = 0; k < count; k++) {
            move(label, targets[k], directions[k]);
            if (!optimal && targets[k] == ground.goal() && labels.state(labels.size() - 1) == ground.goal()) {
                // figure 5 ends at the first sight of the goal
                goalLabel = labels.size() - 1;
                return Verdict.GOAL;
            }
        }
        if (ticks < lastTick) {
            move(label, q, -1);
        }
        return Verdict.EXPANDED;
    }

    private void move(int label, int to, int direction) {
        if (!ground.leads(to)) {
            return;
        }
        int spent = direction < 0 ? Ground.WAIT : direction < 4 ? Ground.STRAIGHT : Ground.DIAGONAL;
        long ticks = labels.space(label) + spent;
        double seconds = lastTick == 0 ? 0 : ticks * tick;
        double x = region.x(to);
        double y = region.y(to);
        boolean predicted = ticks <= lastTick || lastTick == 0;
        if (predicted && (hazards.hits(x, y, seconds) || hazards.hits(x, y, seconds - 0.5 * spent * tick))) {
            return;
        }
        double risk = optimal ? labels.used(label) : 0;
        if (predicted && lastTick > 0) {
            double perSecond = 1 / (spent * tick);
            double vx = direction < 0 ? 0 : GridFrame.dx(direction) * frame.cell() * perSecond;
            double vy = direction < 0 ? 0 : GridFrame.dy(direction) * frame.cell() * perSecond;
            double here = forecast.risk(x, y, vx, vy, forecast.step(seconds));
            risk += optimal ? caution * here * spent * tick : here;
        }
        add(to, label, ticks, risk);
    }

    private void trace(double now, TimedPath path) {
        path.clear();
        for (int label = goalLabel; labels.parent(label) != LabelPool.NONE; label = labels.parent(label)) {
            int q = labels.state(label);
            path.add(region.x(q), region.y(q), now + labels.space(label) * tick, q);
        }
        int first = root();
        path.add(startX, startY, now, labels.state(first));
        path.reverse();
        path.hurryNot(ground.speed());
        end(path);
    }

    private int root() {
        int label = goalLabel;
        while (labels.parent(label) != LabelPool.NONE) {
            label = labels.parent(label);
        }
        return label;
    }

    /** Leads on to the very place of the goal. */
    private void end(TimedPath path) {
        int last = path.size() - 1;
        double dx = ground.goalPlace().x() - path.x(last);
        double dy = ground.goalPlace().y() - path.y(last);
        double more = Math.sqrt(dx * dx + dy * dy);
        if (more > 1e-9) {
            path.add(
                    ground.goalPlace().x(),
                    ground.goalPlace().y(),
                    path.t(last) + more / ground.speed(),
                    ground.goal());
        }
    }
}
