package troupe.unified.search;

import troupe.scene.Ordering;

/** Gives labels the keys that order them. The keys of one configuration grow with the cost so far. */
interface Priority {
    /** The key of a label from which the goal cannot be reached. */
    long NEVER = Long.MAX_VALUE;

    /** Returns the key of a label at a configuration with a cost so far in units, from 0. */
    long key(int configuration, long cost);

    /** Tells whether the key of a configuration is final; else it is a lower bound that can still rise. */
    boolean isFinal(int configuration);

    /**
     * Orders by the cost so far plus {@code weight} times the bound on the cost to go; for weights above 1
     * both are divided by the weight, which keeps the order and cannot overflow. A bound that can
     * still rise stands one unit behind, so that among equals what is known comes first and the search
     * follows the settled way instead of asking about every place beside it.
     */
    record Bound(CostToGo toGo, double weight) implements Priority {
        @Override
        public long key(int configuration, long cost) {
            long bound = toGo.bound(configuration);
            if (bound >= CostToGo.UNREACHABLE) {
                return NEVER;
            }
            long paid = weight == 1 ? cost : (long) (cost / weight);
            return paid + bound + (toGo.isSettled(configuration) ? 0 : 1);
        }

        @Override
        public boolean isFinal(int configuration) {
            return toGo.isSettled(configuration);
        }
    }

    /**
     * Orders as published: {@code a} times the potential in metres plus {@code b} times the cost in J
     * (Unified section 7). The key is the bits of that sum, which order like the numbers from 0.
     */
    record Published(JourneyQuery.Potential potential, JourneyCosts costs, Ordering.Paper weights) implements Priority {
        @Override
        public long key(int configuration, long cost) {
            double metres = potential.at(configuration);
            if (!(metres < Double.POSITIVE_INFINITY)) {
                return NEVER;
            }
            return Double.doubleToRawLongBits(
                    weights.potentialWeight() * metres + weights.costWeight() * costs.joules(cost));
        }

        @Override
        public boolean isFinal(int configuration) {
            return true;
        }
    }
}
