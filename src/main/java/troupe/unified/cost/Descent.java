package troupe.unified.cost;

import troupe.grid.region.Region;

/**
 * Leads from a place down a field to the goal: what expected paths follow. Places are configurations of the
 * guiding region.
 */
public interface Descent {
    /** Stands for no place. */
    int NONE = -1;

    /** Returns the next place down, {@link #NONE} at the goal and where there is none. */
    int next(int place);

    /** Returns a number that orders places as the field does; {@code Long.MAX_VALUE} where the goal is out of reach. */
    long rank(int place);

    /** Follows the cost to go, whose ways end at the goal only. */
    record Cheapest(CostToGo toGo) implements Descent {
        @Override
        public int next(int place) {
            return toGo.next(place);
        }

        @Override
        public long rank(int place) {
            long bound = toGo.bound(place);
            return bound >= CostToGo.UNREACHABLE ? Long.MAX_VALUE : bound;
        }
    }

    /**
     * Goes to the neighbour of least potential, ties by least direction, then number, as long as that lies
     * lower.
     */
    final class Steepest implements Descent {
        private final Region region;
        private final JourneyQuery.Potential potential;
        private final int[] targets = new int[Region.MAX_NEIGHBOURS];
        private final int[] directions = new int[Region.MAX_NEIGHBOURS];

        public Steepest(Region region, JourneyQuery.Potential potential) {
            this.region = region;
            this.potential = potential;
        }

        @Override
        public int next(int place) {
            double least = potential.at(place);
            int best = NONE;
            int count = region.neighbours(place, targets, directions);
            for (int i = 0; i < count; i++) {
                double value = potential.at(targets[i]);
                if (value < least) {
                    least = value;
                    best = targets[i];
                }
            }
            return best;
        }

        @Override
        public long rank(int place) {
            double value = potential.at(place);
            return value < Double.POSITIVE_INFINITY ? Double.doubleToRawLongBits(value) : Long.MAX_VALUE;
        }
    }
}
