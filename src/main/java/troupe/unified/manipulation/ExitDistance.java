package troupe.unified.manipulation;

import troupe.unified.obstacle.Movable;

/**
 * Bounds from below what it still costs to bring an obstacle to a pose that bars nothing, as if nothing stood in its
 * way: the least cost of translations at the same heading, or a turn and then translations of the disc about the centroid
 * that the obstacle holds at every heading. The bound falls by no more than a move costs. Exact distances in a window
 * around where the obstacle stands; what lies outside counts as barring nothing. Tables are made when they are first asked
 * for. Used by one thread at a time.
 */
final class ExitDistance {
    /** How much smaller than the largest the disc within the obstacle is taken, in metres. */
    private static final double SLACK = 1e-6;

    private static final int MARGIN = 3;

    private final ConfigurationSpace barred;
    private final long straight;
    private final long diagonal;
    private final long turn;
    private final int half;
    private final int side;
    private final long[] disc;
    private final long[][] headings;

    /**
     * Prepares the bound.
     *
     * @param straight the least cost of a move by a cell, from 0
     * @param diagonal the least cost of a move by a cell's diagonal, from 0
     * @param turn the least cost of a turn by one heading, from 0
     */
    ExitDistance(Movable movable, ConfigurationSpace barred, long straight, long diagonal, long turn) {
        this.barred = barred;
        this.straight = Math.min(straight, diagonal);
        this.diagonal = Math.min(diagonal, Prices.times(2, straight));
        this.turn = turn;
        this.half = (int) Math.ceil(movable.farthest() / movable.cell())
                + (int) Math.ceil(barred.widest() / movable.cell())
                + MARGIN;
        this.side = 2 * half + 1;
        this.disc = new long[side * side];
        this.headings = new long[movable.headings()][];
        barred.markDisc(movable.innerRadius() - SLACK, half, disc);
        spread(disc);
    }

    /** Returns the bound on the cost to leave what is barred from a pose. */
    long of(int i, int j, int k) {
        if (Math.abs(i) > half || Math.abs(j) > half) {
            return 0;
        }
        if (headings[k] == null) {
            headings[k] = table(k);
        }
        int at = (j + half) * side + i + half;
        long here = headings[k][at];
        return here <= turn ? here : Math.min(here, Prices.sum(turn, disc[at]));
    }

    /** Returns a bound that is no greater than {@link #of}, for which no heading is looked at. */
    long quick(int i, int j, int k) {
        if (headings[k] != null) {
            return of(i, j, k);
        }
        return Math.abs(i) > half || Math.abs(j) > half ? 0 : disc[(j + half) * side + i + half];
    }

    private long[] table(int k) {
        long[] table = new long[side * side];
        barred.mark(k, half, table);
        spread(table);
        return table;
    }

    /** Spreads the distance to the places that are 0, or outside, over the others. */
    private void spread(long[] table) {
        for (int row = 0, at = 0; row < side; row++) {
            for (int col = 0; col < side; col++, at++) {
                if (table[at] != 0) {
                    boolean edge = row == 0 || col == 0 || row == side - 1 || col == side - 1;
                    table[at] = edge ? straight : least(table, at, -1, -side, -side - 1, -side + 1);
                }
            }
        }
        for (int row = side - 1, at = table.length - 1; row >= 0; row--) {
            for (int col = side - 1; col >= 0; col--, at--) {
                if (table[at] > straight) {
                    table[at] = Math.min(table[at], least(table, at, 1, side, side + 1, side - 1));
                }
            }
        }
    }

    private long least(long[] table, int at, int beside, int over, int across, int other) {
        return Math.min(
                Math.min(table[at + beside], table[at + over]) + straight,
                Math.min(table[at + across], table[at + other]) + diagonal);
    }
}
