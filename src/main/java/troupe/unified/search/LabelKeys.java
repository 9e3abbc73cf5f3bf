package troupe.unified.search;

import java.util.List;
import java.util.Optional;
import troupe.search.LabelPool;
import troupe.unified.cost.CostToGo;
import troupe.unified.cost.Priority;

/**
 * Gives labels the keys that order them: by what their place of the guiding region promises, where only moving
 * something leads to the goal by what the exits promise, and in manipulation by the least that it will cost.
 */
final class LabelKeys {
    private final LabelPool labels;
    private final List<SearchSpace> spaces;
    private final List<MoveAttempt> attempts;
    private final Priority priority;
    private final Optional<Enclosures> enclosures;

    /**
     * Makes the keys of the labels of a search.
     *
     * @param spaces the search spaces, which may become more
     * @param attempts the manipulation instances, which may become more
     * @param enclosures what has to be paid where the goal is out of reach; empty if that is not asked for
     */
    LabelKeys(
            LabelPool labels,
            List<SearchSpace> spaces,
            List<MoveAttempt> attempts,
            Priority priority,
            Optional<Enclosures> enclosures) {
        this.labels = labels;
        this.spaces = spaces;
        this.attempts = attempts;
        this.priority = priority;
        this.enclosures = enclosures;
    }

    /** Returns the search space of a label. */
    SearchSpace space(int label) {
        return spaces.get(labels.space(label));
    }

    /** Tells whether a label is in manipulation. */
    boolean isManipulation(int label) {
        return labels.task(label) != LabelPool.NONE;
    }

    /** Returns the manipulation instance of a label that is in manipulation. */
    MoveAttempt attempt(int label) {
        return attempts.get(labels.task(label));
    }

    /** Returns the key of a label, {@link Priority#NEVER} if nothing leads on from it. */
    long key(int label) {
        long cost = labels.cost(label);
        SearchSpace space = space(label);
        if (isManipulation(label)) {
            MoveAttempt attempt = attempt(label);
            long gap = enclosures.isPresent()
                    ? enclosures.get().gap(attempt)
                    : attempt.instance().least();
            return gap == Long.MAX_VALUE
                    ? Priority.NEVER
                    : priority.key(place(space, labels.state(label)), cost + gap, 0);
        }
        Enclosure enclosure = enclosure(label);
        if (enclosure == null) {
            return priority.key(place(space, labels.state(label)), cost, 0);
        }
        return enclosure.toExit().isPresent()
                ? enclosure.toExit().get().key(labels.state(label), cost, 0)
                : priority.key(place(space, labels.state(label)), cost, enclosure.least());
    }

    /** Tells whether the key of a label is final; else it is a lower bound that can still rise. */
    boolean isFinal(int label) {
        Optional<Priority.Bound> toExit = toExit(label);
        return toExit.isPresent()
                ? toExit.get().isFinal(labels.state(label))
                : priority.isFinal(place(space(label), labels.state(label)));
    }

    /**
     * Asks that the bound rise by which a label is judged, until it is exact or has risen by {@code rise}; returns
     * what is to be gone on with.
     */
    CostToGo ask(int label, long rise) {
        Optional<Priority.Bound> toExit = toExit(label);
        return toExit.isPresent()
                ? toExit.get().ask(labels.state(label), rise)
                : priority.ask(place(space(label), labels.state(label)), rise);
    }

    /** Returns the greatest cost to be paid besides, with which the key of a label would not exceed another one. */
    long within(int label, long key) {
        int place = place(space(label), labels.state(label));
        long most = place < 0 ? Long.MAX_VALUE : priority.costWithin(place, key);
        return most == Long.MAX_VALUE ? most : most - labels.cost(label);
    }

    private Optional<Priority.Bound> toExit(int label) {
        Enclosure enclosure = isManipulation(label) ? null : enclosure(label);
        return enclosure == null ? Optional.empty() : enclosure.toExit();
    }

    private Enclosure enclosure(int label) {
        return enclosures.isEmpty()
                ? null
                : space(label).enclosure(labels.state(label)).orElse(null);
    }

    /**
     * Returns the place of the guiding region by which a configuration is judged: where a crossing can be walked
     * there, too, the one that promises less; -1 if there is none.
     */
    int place(SearchSpace space, int configuration) {
        int place = space.guided(configuration);
        int beneath = space.beneath(configuration);
        if (beneath < 0) {
            return place;
        }
        return place < 0 || priority.isBefore(beneath, place) ? beneath : place;
    }
}
