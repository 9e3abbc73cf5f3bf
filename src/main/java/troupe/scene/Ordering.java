package troupe.scene;

/** Says in which order the unified planner takes labels from its open list. */
public sealed interface Ordering {

    /** The default: least cost first, with an admissible bound on the cost to go. */
    Ordering OPTIMAL = new Optimal();

    /** A* with an admissible cost-to-go; the result has least cost. */
    record Optimal() implements Ordering {}

    /** The published order (Unified section 7): {@code potentialWeight} x potential (m) + {@code costWeight} x cost (J). */
    record Paper(double potentialWeight, double costWeight) implements Ordering {

        /** Checks that both weights are finite and not negative, and one of them positive. */
        public Paper {
            if (!(potentialWeight >= 0 && costWeight >= 0 && potentialWeight + costWeight > 0)
                    || Double.isInfinite(potentialWeight + costWeight)) {
                throw new IllegalArgumentException("ordering=paper(" + potentialWeight + "," + costWeight
                        + "); needs two numbers from 0, not both 0");
            }
        }
    }

    /** A* with the bound times {@code weight}; the cost is at most {@code weight} times the least. */
    record Bounded(double weight) implements Ordering {

        /** Checks that the weight is finite and at least 1. */
        public Bounded {
            if (!(weight >= 1) || Double.isInfinite(weight)) {
                throw new IllegalArgumentException("ordering=bounded(" + weight + "); needs a number from 1");
            }
        }
    }
}
