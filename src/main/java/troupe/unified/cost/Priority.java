package troupe.unified.cost;

import troupe.scene.Ordering;

/**
 * Gives labels the keys that order them. Places are configurations of the guiding region, -1 for one that has
 * no place there. The keys of one place grow with the cost so far.
 */
public interface Priority {
    /** The key of a label from which the goal cannot be reached. */
    long NEVER = Long.MAX_VALUE;

    /**
     * Returns the key of a label at a place.
     *
     * @param cost the cost so far in units, from 0
     * @param extra what has to be paid at least besides the bound on the cost to go; {@code Long.MAX_VALUE} if
     *     nothing leads on
     */
    long key(int place, long cost, long extra);

    /**
     * Tells whether one place promises less than another one does, so that it is the one to judge by; of two that promise
     * the same, one that may still turn out to cost more.
     */
    boolean isBefore(int place, int other);

    /** Tells whether the key of a place is final; else it is a lower bound that can still rise. */
    boolean isFinal(int place);

    /**
     * Asks that the bound of a place rise, until it is exact or has risen by {@code rise}; returns what is to be gone
     * on with.
     *
     * @throws IllegalStateException if every key is final
     */
    CostToGo ask(int place, long rise);

    /** Returns the greatest cost so far in units with which the key of a place does not exceed {@code key}. */
    long costWithin(int place, long key);

    /**
     * Orders by the cost so far plus {@code weight} times the bound on the cost to go; for weights above 1
     * both are divided by the weight, which keeps the order and cannot overflow. A bound that can
     * still rise stands one unit behind, so that among equals what is known comes first and the search
     * follows the settled way instead of asking about every place beside it. Without a place the bound is 0.
     */
    record Bound(CostToGo toGo, double weight) implements Priority {
        @Override
        public long key(int place, long cost, long extra) {
            if (extra == Long.MAX_VALUE) {
                return NEVER;
            }
            long paid = (weight == 1 ? cost : (long) (cost / weight)) + extra;
            if (place < 0) {
                return paid;
            }
            long bound = toGo.bound(place);
            return bound >= CostToGo.UNREACHABLE ? NEVER : paid + bound + (toGo.isSettled(place) ? 0 : 1);
        }

        @Override
        public boolean isBefore(int place, int other) {
            long bound = toGo.bound(place);
            long otherBound = toGo.bound(other);
            return bound < otherBound || bound == otherBound && !toGo.isSettled(place);
        }

        @Override
        public boolean isFinal(int place) {
            return place < 0 || toGo.isSettled(place);
        }

        @Override
        public CostToGo ask(int place, long rise) {
            toGo.want(place, Math.min(CostToGo.UNREACHABLE, toGo.bound(place) + rise));
            return toGo;
        }

        @Override
        public long costWithin(int place, long key) {
            long paid = key - toGo.bound(place);
            return weight == 1 ? paid : (long) (paid * weight);
        }
    }

    /**
     * Orders as published: {@code a} times the potential in metres plus {@code b} times the cost in J
     * (Unified section 7). The key is the bits of that sum, which order like the numbers from 0. What has no
     * place is not tried.
     */
    record Published(JourneyQuery.Potential potential, JourneyCosts costs, Ordering.Paper weights) implements Priority {
        @Override
        public long key(int place, long cost, long extra) {
            double metres = place < 0 ? Double.POSITIVE_INFINITY : potential.at(place);
            if (!(metres < Double.POSITIVE_INFINITY)) {
                return NEVER;
            }
            return Double.doubleToRawLongBits(
                    weights.potentialWeight() * metres + weights.costWeight() * costs.joules(cost));
        }

        @Override
        public boolean isBefore(int place, int other) {
            return key(place, 0, 0) < key(other, 0, 0);
        }

        @Override
        public boolean isFinal(int place) {
            return true;
        }

        @Override
        public CostToGo ask(int place, long rise) {
            throw new IllegalStateException("the published key of place " + place + " is final");
        }

        @Override
        public long costWithin(int place, long key) {
            return Long.MAX_VALUE;
        }
    }
}
