package troupe.unified.search;

import troupe.grid.region.ground.Kind;
import troupe.search.LabelPool;

/**
 * Keeps, for each configuration of each search space, the labels that do not dominate each other. One label dominates another
 * of the same configuration if it costs no more, has used up no more of a limit, and is in the same
 * crossing, one that began at the same place, or in none. With {@code visited} marks, a stable
 * configuration keeps its first label only (Unified figure 6).
 */
final class LabelChains {
    private static final int DOMINATED = JourneyWorkspace.DOMINATED;

    private final LabelPool labels;
    private final int generation;
    private final boolean marksVisited;

    /** Makes empty chains in the memory of a workspace. */
    LabelChains(JourneyWorkspace work, int generation, boolean marksVisited) {
        labels = work.labels;
        this.generation = generation;
        this.marksVisited = marksVisited;
    }

    /** Adds a label unless one that is there dominates it, and drops those that it dominates; returns it or NONE. */
    int install(SearchSpace space, int configuration, int parent, long cost, double used, int begin) {
        int first = space.chains().first(configuration, generation);
        if (first != LabelPool.NONE) {
            if (marksVisited && space.region().kind(configuration) == Kind.STABLE) {
                return LabelPool.NONE;
            }
            for (int other = first; other != LabelPool.NONE; other = labels.next(other)) {
                if (labels.begin(other) == begin && labels.cost(other) <= cost && labels.used(other) <= used) {
                    return LabelPool.NONE;
                }
            }
            first = withoutDominated(first, cost, used, begin);
        }
        int label = labels.add(space.number(), configuration, parent, cost, used, begin, first);
        space.chains().put(configuration, generation, label);
        return label;
    }

    private int withoutDominated(int first, long cost, double used, int begin) {
        int kept = first;
        int previous = LabelPool.NONE;
        int other = first;
        while (other != LabelPool.NONE) {
            int next = labels.next(other);
            if (labels.begin(other) == begin && cost <= labels.cost(other) && used <= labels.used(other)) {
                labels.setNext(other, DOMINATED);
                if (previous == LabelPool.NONE) {
                    kept = next;
                } else {
                    labels.setNext(previous, next);
                }
            } else {
                previous = other;
            }
            other = next;
        }
        return kept;
    }

    /** Tells whether a label has been dominated since it was added. */
    boolean isDominated(int label) {
        return labels.next(label) == DOMINATED;
    }
}
