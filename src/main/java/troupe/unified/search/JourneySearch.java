package troupe.unified.search;

import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import troupe.grid.region.Region;
import troupe.scene.Ordering;
import troupe.search.BestFirst;
import troupe.search.Expander;
import troupe.search.LabelPool;
import troupe.search.OpenList;
import troupe.search.Outcome;

/**
 * Searches for a way of an actor over a region with all its abilities at once (Unified figures 6 and 7).
 *
 * <p>A label is a way to a configuration: its cost, how far it has travelled on unstable places, and where
 * a crossing began. A configuration keeps all labels that do not dominate each other, so that on the grid
 * a legal way is found whenever there is one. With the ordering {@code optimal} it has least cost, with
 * {@code bounded(w)} at most {@code w} times the least; {@code paper} takes the published order and marks
 * stable configurations visited when they pass {@code LEGAL}, so it may miss ways.
 *
 * <p>Deviations from the source are listed in {@code docs/unified.md}. Used by one thread at a time. All
 * state is here and in the workspace, which no other search may use meanwhile.
 */
public final class JourneySearch implements Expander {
    private static final Outcome NO_WAY = new Outcome.Infeasible("no legal way leads from the start to the goal");

    private final JourneyWorkspace work;
    private final int generation;
    private final Region region;
    private final JourneyCosts costs;
    private final JourneyQuery query;
    private final LabelPool labels;
    private final OpenList open;
    private final CostToGo toGo;
    private final Priority priority;
    private final LegalSteps legal;
    private final LabelChains chains;
    private final BestFirst search;

    private final boolean monotone;

    private int waiting = LabelPool.NONE;
    private long waitingKey;
    private int reached = LabelPool.NONE;

    /**
     * Prepares a search.
     *
     * @param work memory for the region; an earlier search that used it is void
     * @param costs what steps cost; made for the actor of the region
     * @param query start, goal, ordering and limit
     * @throws IllegalArgumentException if start or goal is not an open span of the region
     */
    public JourneySearch(JourneyWorkspace work, JourneyCosts costs, JourneyQuery query) {
        this.work = work;
        this.region = work.region();
        this.costs = costs;
        this.query = query;
        checkPlace("start", query.start());
        checkPlace("goal", query.goal());
        generation = work.begin(costs);
        labels = work.labels;
        if (query.ordering() instanceof Ordering.Paper paper) {
            toGo = null;
            priority = new Priority.Published(query.potential(), costs, paper);
            open = work.heap;
        } else {
            toGo = new CostToGo(work, generation, costs, query.start(), query.goal());
            double weight = query.ordering() instanceof Ordering.Bounded bounded ? bounded.weight() : 1;
            priority = new Priority.Bound(toGo, weight);
            open = weight == 1 ? work.forward() : work.heap;
        }
        monotone = open == work.forward();
        boolean marksVisited = toGo == null;
        chains = new LabelChains(work, generation, marksVisited);
        legal = new LegalSteps(region, costs);
        search = new BestFirst(open, this, NO_WAY, query.expansions());
        install(query.start(), LabelPool.NONE, 0, 0, LabelPool.NONE, 0);
    }

    private void checkPlace(String name, int configuration) {
        if (configuration < 0 || configuration >= region.spanCount() || !region.open(configuration)) {
            throw new IllegalArgumentException(
                    name + "=" + configuration + "; needs a place of the region where the actor can stand");
        }
    }

    /**
     * Does at most {@code budget} expansions, those of the cost to go included. The result does not depend
     * on how the work is sliced.
     *
     * @param budget at least 1
     * @throws IllegalArgumentException if the budget is below 1
     * @throws IllegalStateException if another search has taken over the workspace
     */
    public Outcome step(long budget) {
        if (budget < 1) {
            throw new IllegalArgumentException("budget=" + budget + "; needs at least 1");
        }
        work.check(generation);
        long left = budget;
        while (left > 0 && search.outcome().isRunning()) {
            if (waiting != LabelPool.NONE) {
                left -= toGo.advance(left);
                if (toGo.hasAnswered()) {
                    int label = waiting;
                    waiting = LabelPool.NONE;
                    put(label, waitingKey);
                }
            } else {
                long before = search.expanded();
                search.step(left);
                left -= search.expanded() - before;
            }
        }
        return search.outcome();
    }

    /** Returns how the search stands. */
    public Outcome outcome() {
        return search.outcome();
    }

    /** Ends the search with the outcome {@code Cancelled}, unless it has ended already. */
    public void cancel() {
        search.cancel();
    }

    /** Returns the labels expanded so far, without the expansions of the cost to go. */
    public long expanded() {
        return search.expanded();
    }

    /** Returns the labels made so far, without those that were dominated when they were made. */
    public long generated() {
        work.check(generation);
        return labels.size();
    }

    /** Returns the configurations that the search for the cost to go has expanded, 0 for {@code paper}. */
    public long estimated() {
        return toGo == null ? 0 : toGo.expanded();
    }

    /** Visits the configuration of every label in the order of making; one configuration may come again. */
    public void forEachLabel(IntConsumer visitor) {
        work.check(generation);
        for (int label = 0; label < labels.size(); label++) {
            visitor.accept(labels.state(label));
        }
    }

    /** Returns a lower bound in J on the cost from a configuration to the goal, infinite if there is no way. */
    public double bound(int configuration) {
        work.check(generation);
        long bound = toGo == null ? 0 : toGo.bound(configuration);
        return bound >= CostToGo.UNREACHABLE ? Double.POSITIVE_INFINITY : costs.joules(bound);
    }

    /** Returns the way that was found, empty unless the outcome is {@code Found}. Cost O(its steps). */
    public Optional<JourneyPath> path() {
        if (reached == LabelPool.NONE) {
            return Optional.empty();
        }
        work.check(generation);
        int count = 0;
        for (int label = reached; label != LabelPool.NONE; label = labels.parent(label)) {
            count++;
        }
        int[] configurations = new int[count];
        for (int label = reached; label != LabelPool.NONE; label = labels.parent(label)) {
            configurations[--count] = labels.state(label);
        }
        return Optional.of(JourneyPath.of(costs, List.of(JourneyPath.way(region, costs, configurations))));
    }

    @Override
    public Verdict expand(int label, long key) {
        if (chains.isDominated(label)) {
            return Verdict.SKIPPED;
        }
        int from = labels.state(label);
        long now = priority.key(from, labels.cost(label));
        if (now > key) {
            put(label, key);
            return Verdict.SKIPPED;
        }
        if (!priority.isFinal(from)) {
            waiting = label;
            waitingKey = key;
            long bound = toGo.bound(from);
            toGo.want(from, open.isEmpty() ? CostToGo.UNREACHABLE : bound + 1 + costs.cheapestStraight());
            return Verdict.WAITING;
        }
        if (from == query.goal()) {
            reached = label;
            return Verdict.GOAL;
        }
        if (region.plain(from)) {
            expandPlain(label, from, key);
        } else {
            expandLinked(label, from, key);
        }
        return Verdict.EXPANDED;
    }

    private void expandPlain(int label, int from, long key) {
        for (int rest = region.moves(from); rest != 0; rest &= rest - 1) {
            int direction = Integer.numberOfTrailingZeros(rest);
            take(label, from, from + work.offsets[direction], direction, key);
        }
    }

    private void expandLinked(int label, int from, long key) {
        int count = region.neighbours(from, work.targets, work.directions);
        for (int i = 0; i < count; i++) {
            take(label, from, work.targets[i], work.directions[i], key);
        }
    }

    private void take(int label, int from, int to, int direction, long key) {
        if (legal.check(from, labels.used(label), labels.begin(label), to, direction)) {
            install(to, label, labels.cost(label) + legal.cost(), legal.used(), legal.begin(), key);
        }
    }

    private void install(int configuration, int parent, long cost, double used, int begin, long parentKey) {
        int label = chains.install(configuration, parent, cost, used, begin);
        if (label != LabelPool.NONE) {
            put(label, parentKey);
        }
    }

    /** Opens a label; in a monotone list, where rounding must not take a key back, not before {@code least}. */
    private void put(int label, long least) {
        long cost = labels.cost(label);
        long key = priority.key(labels.state(label), cost);
        if (key < Priority.NEVER) {
            open.add(label, monotone ? Math.max(key, least) : key, cost);
        }
    }
}
