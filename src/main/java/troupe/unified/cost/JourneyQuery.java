package troupe.unified.cost;

import troupe.scene.Ordering;

/**
 * Asks for a way between two configurations of a region.
 *
 * @param start the configuration to start from
 * @param goal the configuration to reach
 * @param ordering the order in which labels are taken
 * @param potential what the {@code paper} ordering descends; the other orderings do not ask it
 * @param expansions the most labels the search may expand before it ends as exhausted, at least 1
 */
public record JourneyQuery(int start, int goal, Ordering ordering, Potential potential, long expansions) {

    /** Tells the potential of a configuration in metres: 0 at the goal, not finite where the goal is out of reach. */
    @FunctionalInterface
    public interface Potential {
        /** The potential that is 0 everywhere. */
        Potential NONE = configuration -> 0;

        /** Returns the potential of a configuration. */
        double at(int configuration);
    }

    /** Checks the limit. */
    public JourneyQuery {
        if (expansions < 1) {
            throw new IllegalArgumentException("limit.expansions=" + expansions + "; needs at least 1");
        }
    }

    /** Asks for a way of least cost, with no limit on the work. */
    public static JourneyQuery optimal(int start, int goal) {
        return new JourneyQuery(start, goal, Ordering.OPTIMAL, Potential.NONE, Long.MAX_VALUE);
    }
}
