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
import troupe.unified.cost.CostToGo;
import troupe.unified.cost.Descent;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.JourneyQuery;
import troupe.unified.cost.LegalSteps;
import troupe.unified.cost.Moving;
import troupe.unified.cost.Priority;
import troupe.unified.manipulation.Instance;
import troupe.unified.manipulation.Transfer;

/**
 * Searches for a way of an actor with all its abilities at once, over search spaces that arise when
 * obstacles are moved (Unified figures 6 and 7).
 *
 * <p>A label is a way to a configuration of a space: its cost, how far it has travelled on unstable places,
 * and where a crossing began. A configuration keeps all labels that do not dominate each other, so that on
 * the grid a legal way is found whenever there is one. A label at a trigger point is besides the
 * beginning of a manipulation: its instance gets a slice of work whenever such a label comes first, and
 * when it has found a place for the obstacle, the label goes on in the space in which the obstacle is there. With
 * the ordering {@code optimal} the way has least cost, with {@code bounded(w)} at most {@code w} times the least;
 * {@code paper} takes the published order and marks stable configurations visited when they pass {@code LEGAL},
 * so it may miss ways.
 *
 * <p>Deviations from the source are listed in {@code docs/unified.md}. Used by one thread at a time. All
 * state is here and in the workspace, which no other search may use meanwhile.
 */
public final class JourneySearch implements Expander {
    private static final Outcome NO_WAY = new Outcome.Infeasible("no legal way leads from the start to the goal");

    private final JourneyWorkspace work;
    private final int generation;
    private final JourneyCosts costs;
    private final JourneyQuery query;
    private final LabelPool labels;
    private final OpenList open;
    private final CostToGo toGo;
    private final LabelKeys keys;
    private final LabelChains chains;
    private final BestFirst search;
    private final SearchSpace base;
    private final Manipulations manipulations;
    private final Optional<Enclosures> enclosures;
    private final int slice;
    private final int[] found;
    private final boolean monotone;

    private final Awaited awaited = new Awaited();
    private int reached = LabelPool.NONE;
    private long manipulated;
    private boolean crowded;

    /**
     * Prepares a search in which nothing is moved.
     *
     * @param work memory for the region; an earlier search that used it is void
     * @param costs what steps cost; made for the actor of the region
     * @param query start, goal, ordering and limit
     * @throws IllegalArgumentException if start or goal is not an open span of the region
     */
    public JourneySearch(JourneyWorkspace work, JourneyCosts costs, JourneyQuery query) {
        this(work, costs, query, Moving.NOTHING);
    }

    /**
     * Prepares a search.
     *
     * @param work memory for the region and the widest region; an earlier search that used it is void
     * @param costs what steps cost; made for the actor of the region
     * @param query start, goal, ordering and limit
     * @param moving what may be moved, and how
     * @throws IllegalArgumentException if the start is not an open span of the region, or the goal is not one of
     *     the widest region
     */
    public JourneySearch(JourneyWorkspace work, JourneyCosts costs, JourneyQuery query, Moving moving) {
        this.work = work;
        this.costs = costs;
        this.query = query;
        checkPlace("start", work.region, query.start());
        checkPlace("goal", work.widest, query.goal());
        generation = work.begin(costs);
        labels = work.labels;
        double weight = query.ordering() instanceof Ordering.Bounded bounded ? bounded.weight() : 1;
        boolean published = query.ordering() instanceof Ordering.Paper;
        Priority priority;
        Region guide = published ? moving.guide().orElse(work.region) : work.widest;
        if (query.ordering() instanceof Ordering.Paper paper) {
            toGo = null;
            priority = new Priority.Published(query.potential(), costs, paper);
            open = work.heap;
        } else {
            toGo = new CostToGo(work.field, costs, query.start(), CostToGo.Ends.at(query.goal()));
            priority = new Priority.Bound(toGo, weight);
            open = weight == 1 ? work.forward() : work.heap;
        }
        monotone = open == work.forward();
        chains = new LabelChains(work, generation, published);
        base = new SearchSpace(work.region, guide, moving, work.chains, costs);
        Descent descent = published ? new Descent.Steepest(guide, moving.potential()) : new Descent.Cheapest(toGo);
        found = new int[moving.movables().size()];
        manipulations = moving.isPossible()
                ? new Manipulations(
                        moving, costs, new ExpectedPaths(guide, descent, costs, published, found.length), base)
                : null;
        enclosures = moving.isPossible() && toGo != null
                ? Optional.of(new Enclosures(manipulations, toGo, costs, weight, query.goal()))
                : Optional.empty();
        if (enclosures.isPresent()) {
            work.around.ifPresent(reach -> base.know(reach, query.goal()));
        }
        keys = new LabelKeys(labels, spaces(), attempts(), priority, enclosures);
        slice = moving.slice();
        search = new BestFirst(open, this, NO_WAY, query.expansions());
        install(base, query.start(), LabelPool.NONE, 0, 0, LabelPool.NONE, 0);
    }

    private static void checkPlace(String name, Region region, int configuration) {
        if (configuration < 0 || configuration >= region.spanCount() || !region.open(configuration)) {
            throw new IllegalArgumentException(
                    name + "=" + configuration + "; needs a place of the region where the actor can stand");
        }
    }

    /**
     * Does at most {@code budget} expansions, those of the cost to go and of manipulation instances included.
     * The result does not depend on how the work is sliced.
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
            if (awaited.isThere()) {
                left -= advanceAwaited(left);
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

    /** Tells whether it ended because another search space would have been one too many. */
    public boolean isCrowded() {
        return crowded;
    }

    /** Ends the search with the outcome {@code Cancelled}, unless it has ended already. */
    void cancel() {
        search.cancel();
    }

    /** Returns the labels expanded so far, without the expansions of the cost to go and of instances. */
    public long expanded() {
        return search.expanded() - manipulated;
    }

    /** Returns the poses that manipulation instances have expanded so far. */
    public long manipulated() {
        return manipulated;
    }

    /** Returns the labels made so far, without those that were dominated when they were made. */
    public long generated() {
        work.check(generation);
        return labels.size();
    }

    /** Returns the configurations that the search for the cost to go has expanded, 0 for {@code paper}. */
    public long estimated() {
        return toGo == null
                ? 0
                : toGo.expanded() + enclosures.map(Enclosures::expanded).orElse(0L);
    }

    /** Returns the search spaces in the order in which they arose; the first is the scene as it stands. */
    public List<SearchSpace> spaces() {
        return manipulations == null ? List.of(base) : manipulations.spaces();
    }

    private List<MoveAttempt> attempts() {
        return manipulations == null ? List.of() : manipulations.attempts();
    }

    /** Visits the configuration of every label of a space in the order of making; one may come again. */
    public void forEachLabel(SearchSpace space, IntConsumer visitor) {
        work.check(generation);
        for (int label = 0; label < labels.size(); label++) {
            if (labels.space(label) == space.number()) {
                visitor.accept(labels.state(label));
            }
        }
    }

    /** Returns what was found, empty unless the outcome is {@code Found}. Cost O(its steps). */
    public Optional<JourneyPath> path() {
        if (reached == LabelPool.NONE) {
            return Optional.empty();
        }
        work.check(generation);
        return Optional.of(new PathTrace(labels, spaces(), attempts()).path(reached, costs));
    }

    @Override
    public Verdict expand(int label, long key) {
        if (chains.isDominated(label)) {
            return Verdict.SKIPPED;
        }
        if (keys.key(label) > key) {
            put(label, key);
            return Verdict.SKIPPED;
        }
        SearchSpace space = keys.space(label);
        int from = labels.state(label);
        if (enclosures.isPresent() && !keys.isManipulation(label)) {
            Enclosure enclosure = enclosures.get().of(space, from);
            if (!enclosure.isOpen() && enclosure.toExit().isEmpty()) {
                return leadOut(enclosures.get(), enclosure, label, key);
            }
        }
        if (!keys.isFinal(label)) {
            return awaited.answer(
                    keys.ask(label, open.isEmpty() ? CostToGo.UNREACHABLE : 1 + costs.cheapestStraight()), label, key);
        }
        if (keys.isManipulation(label)) {
            return expandManipulation(label, key);
        }
        if (from == query.goal()) {
            reached = label;
            return Verdict.GOAL;
        }
        if (manipulations != null && space.region().takesOff(from) && manipulations.isNear(space, from)) {
            if (!isExact(new int[] {from}) || !isExact(manipulations.wanted(space, from))) {
                return awaited.answer(toGo, label, key);
            }
            begin(label, space, from, key);
        }
        space.countExpanded();
        if (space.region().plain(from)) {
            expandPlain(label, space, from, key);
        } else {
            expandLinked(label, space, from, key);
        }
        return Verdict.EXPANDED;
    }

    /**
     * Waits, where the goal is out of reach in this space, until it is known what it costs at least to move
     * something, and then looks for the ways there.
     */
    private Verdict leadOut(Enclosures all, Enclosure enclosure, int label, long key) {
        SearchSpace space = keys.space(label);
        if (!all.isKnown(space, enclosure)) {
            return awaited.answer(toGo, label, key);
        }
        Optional<MoveAttempt> deciding = all.deciding(enclosure);
        if (deciding.isPresent()) {
            MoveAttempt attempt = deciding.get();
            long most = Math.min(attempt.leastOf(enclosure.others()), mostWorth(label, attempt));
            return awaited.turn(new Turn(attempt, slice, most), Optional.of(enclosure), label, key);
        }
        all.lead(space, enclosure, labels.state(label));
        put(label, key);
        return Verdict.SKIPPED;
    }

    /** Tells whether the field is exact at some places; else the cost to go has been asked for them. */
    private boolean isExact(int[] places) {
        if (toGo == null || places.length == 0) {
            return true;
        }
        toGo.wantExact(places);
        return toGo.isExact();
    }

    /** Opens a label in manipulation for each attempt that begins where a label stands. */
    private void begin(int label, SearchSpace space, int from, long key) {
        int count = manipulations.at(space, from, found);
        for (int i = 0; i < count; i++) {
            if (!(manipulations.attempts().get(found[i]).outcome() instanceof Outcome.Infeasible)) {
                int begun =
                        labels.add(space.number(), from, label, labels.cost(label), 0, LabelPool.NONE, LabelPool.NONE);
                labels.setTask(begun, found[i]);
                put(begun, key);
            }
        }
    }

    private Verdict expandManipulation(int label, long key) {
        MoveAttempt attempt = keys.attempt(label);
        if (attempt.outcome().isRunning()) {
            Turn turn = new Turn(attempt, slice, mostWorth(label, attempt));
            return awaited.turn(turn, Optional.empty(), label, key);
        }
        if (attempt.outcome().isFound()) {
            goOn(label, attempt, key);
        }
        return Verdict.EXPANDED;
    }

    /** Works on what a label waits for with at most {@code budget} expansions; returns those made. */
    private long advanceAwaited(long budget) {
        boolean turn = awaited.isTurn();
        long done = awaited.advance(budget);
        if (turn) {
            manipulated += done;
            search.charge(done);
        }
        if (awaited.end()) {
            if (turn) {
                awaited.enclosure()
                        .ifPresent(enclosure -> enclosures.orElseThrow().update(enclosure));
            }
            put(awaited.label(), awaited.key());
        }
        return done;
    }

    /** Returns the greatest least cost of an instance with which its label still comes first. */
    private long mostWorth(int label, MoveAttempt attempt) {
        if (open.isEmpty()) {
            return Long.MAX_VALUE;
        }
        long within = keys.within(label, open.firstKey());
        return within == Long.MAX_VALUE || toGo == null ? within : attempt.leastOf(within);
    }

    /** Goes on, with an obstacle moved, in the space where it is. */
    private void goOn(int label, MoveAttempt attempt, long key) {
        Instance instance = attempt.instance();
        SearchSpace space = manipulations.after(attempt);
        if (space == null) {
            crowded = search.outcome().isRunning();
            search.exhaust();
            return;
        }
        Transfer transfer = instance.transfer();
        int at = transfer.gripped() ? transfer.to() : labels.state(label);
        if (space.region().takesOff(at)) {
            install(space, at, label, labels.cost(label) + instance.cost(), 0, LabelPool.NONE, key);
        }
    }

    private void expandPlain(int label, SearchSpace space, int from, long key) {
        for (int rest = space.region().moves(from); rest != 0; rest &= rest - 1) {
            int direction = Integer.numberOfTrailingZeros(rest);
            take(label, space, from, from + work.offsets[direction], direction, key);
        }
    }

    private void expandLinked(int label, SearchSpace space, int from, long key) {
        int count = space.region().neighbours(from, work.targets, work.directions);
        for (int i = 0; i < count; i++) {
            take(label, space, from, work.targets[i], work.directions[i], key);
        }
    }

    private void take(int label, SearchSpace space, int from, int to, int direction, long key) {
        LegalSteps legal = space.legal();
        if (legal.check(from, labels.used(label), labels.begin(label), to, direction)) {
            install(space, to, label, labels.cost(label) + legal.cost(), legal.used(), legal.begin(), key);
        }
    }

    private void install(
            SearchSpace space, int configuration, int parent, long cost, double used, int begin, long parentKey) {
        int label = chains.install(space, configuration, parent, cost, used, begin);
        if (label != LabelPool.NONE) {
            space.countGenerated();
            put(label, parentKey);
        }
    }

    /** Opens a label; in a monotone list, where rounding must not take a key back, not before {@code least}. */
    private void put(int label, long least) {
        long key = keys.key(label);
        if (key < Priority.NEVER) {
            open.add(label, monotone ? Math.max(key, least) : key, labels.cost(label));
        }
    }
}
