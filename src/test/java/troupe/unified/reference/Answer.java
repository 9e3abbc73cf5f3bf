package troupe.unified.reference;

import java.util.List;

/**
 * Holds what the reference found: the least cost in J, infinite if there is no way, and for one of the best ways
 * the obstacles that it moves, in that order, with the poses to which it moves them.
 *
 * @param spaces how many search spaces were looked at
 */
record Answer(double cost, List<Moved> moved, int spaces) {

    /** An obstacle, by id, and where it was put. */
    record Moved(String obstacle, Mover.Pose pose) {}

    boolean isSolved() {
        return cost < Double.POSITIVE_INFINITY;
    }
}
