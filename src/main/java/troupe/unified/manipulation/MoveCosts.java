package troupe.unified.manipulation;

import java.util.Optional;
import troupe.grid.GridFrame;
import troupe.unified.obstacle.Grip;

/**
 * Says what the moves of an obstacle between the poses of its lattice cost, in units of the prices: the obstacle's part
 * and, with a grip, what the actor walks with it. Immutable.
 */
final class MoveCosts {
    private static final int STRAIGHT = 4;

    private final Prices prices;
    private final Optional<Grip> grip;
    private final int headings;
    private final long[] shifts = new long[GridFrame.DIRECTIONS];

    /** Prepares the costs of the moves that a question asks about. */
    MoveCosts(Question question) {
        prices = question.prices();
        grip = question.grip();
        headings = question.movable().headings();
        for (int d = 0; d < shifts.length; d++) {
            shifts[d] = d < STRAIGHT ? prices.straight() : prices.diagonal();
            if (grip.isPresent()) {
                shifts[d] = Prices.sum(shifts[d], d < STRAIGHT ? prices.walkStraight() : prices.walkDiagonal());
            }
        }
    }

    /** Returns the cost of a shift by one cell. */
    long shift(int direction) {
        return shifts[direction];
    }

    /** Returns the cost of a straight shift. */
    long straight() {
        return shifts[0];
    }

    /** Returns the cost of a diagonal shift. */
    long diagonal() {
        return shifts[STRAIGHT];
    }

    /** Returns the cost of the turn between heading {@code lower} and the next. */
    long turn(int lower) {
        if (grip.isEmpty()) {
            return prices.turn();
        }
        long straight = Prices.times(grip.get().straightSteps(lower), prices.walkStraight());
        long diagonal = Prices.times(grip.get().diagonalSteps(lower), prices.walkDiagonal());
        return Prices.sum(prices.turn(), Prices.sum(straight, diagonal));
    }

    /** Returns the cost of the cheapest turn, {@link Prices#BLOCKED} if nothing is turned. */
    long leastTurn() {
        long least = Prices.BLOCKED;
        for (int k = 0; headings > 1 && k < headings; k++) {
            least = Math.min(least, turn(k));
        }
        return least;
    }

    /** Returns the least share, from 0 to 1, that moving the obstacle has in the cost of a move: the rest is walking. */
    double obstacleShare() {
        if (grip.isEmpty()) {
            return 1;
        }
        double least = Math.min(
                share(prices.straight(), prices.walkStraight()), share(prices.diagonal(), prices.walkDiagonal()));
        for (int k = 0; headings > 1 && k < headings; k++) {
            least = Math.min(least, share(prices.turn(), turn(k) - prices.turn()));
        }
        return least;
    }

    private static double share(double moving, double walking) {
        return moving + walking == 0 ? 1 : moving / (moving + walking);
    }
}
