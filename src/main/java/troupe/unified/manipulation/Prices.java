package troupe.unified.manipulation;

/**
 * Holds what the moves of an obstacle cost, in whole units of one's choice, each from 0.
 *
 * @param straight moving the obstacle by a cell
 * @param diagonal moving it by a cell's diagonal
 * @param turn turning it by one heading
 * @param walkStraight a straight step of the actor that holds it
 * @param walkDiagonal a diagonal step of the actor that holds it
 */
public record Prices(long straight, long diagonal, long turn, long walkStraight, long walkDiagonal) {
    /** The least cost of a move that is not allowed any more, and of a sum that would be too large. */
    public static final long BLOCKED = Long.MAX_VALUE / 8;

    /** Checks that none is negative. */
    public Prices {
        if (straight < 0 || diagonal < 0 || turn < 0 || walkStraight < 0 || walkDiagonal < 0) {
            throw new IllegalArgumentException("prices " + straight + ", " + diagonal + ", " + turn + ", "
                    + walkStraight + ", " + walkDiagonal + "; none may be negative");
        }
    }

    /** Returns the sum of two costs, {@link #BLOCKED} if it reaches that. */
    static long sum(long a, long b) {
        return a >= BLOCKED || b >= BLOCKED - a ? BLOCKED : a + b;
    }

    /** Returns {@code count} times a cost, {@link #BLOCKED} if it reaches that. */
    static long times(long count, long cost) {
        return count > 0 && cost >= BLOCKED / count ? BLOCKED : count * cost;
    }
}
