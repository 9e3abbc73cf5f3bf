package troupe.unified.search;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import troupe.geometry.Point;
import troupe.grid.GridFrame;
import troupe.unified.obstacle.Movable;

/**
 * Holds the trigger points of one obstacle in one search space, and which of them begin a manipulation
 * instance: each point has a leader, the point from which the instance that it may begin expects to go on.
 */
final class TriggerTable {
    /** Stands for a leader that is not known yet, and for an attempt that has not been made yet. */
    static final int UNKNOWN = -2;

    /** Stands for no leader, and for an attempt that there is no reason to make. */
    static final int NONE = -1;

    private final int[] points;
    private final int[] leaders;
    private final int[] attempts;

    /** Makes the table of ascending trigger points; their leaders are not known yet. */
    TriggerTable(int[] points) {
        this.points = points;
        this.leaders = new int[points.length];
        this.attempts = new int[points.length];
        Arrays.fill(leaders, UNKNOWN);
        Arrays.fill(attempts, UNKNOWN);
    }

    /**
     * Returns the table of a space in which nothing has changed near the obstacle: the same points, and the same
     * leaders if {@code sameLeaders}, but no attempts.
     */
    TriggerTable again(boolean sameLeaders) {
        TriggerTable table = new TriggerTable(points);
        if (sameLeaders) {
            System.arraycopy(leaders, 0, table.leaders, 0, leaders.length);
        }
        return table;
    }

    /** Makes each trigger point of a hold its own leader: the one nearest to it, ties by number. Cost O(holds × points). */
    void leadByHolds(Movable movable, GridFrame frame) {
        Arrays.fill(leaders, NONE);
        for (Point hold : movable.holds()) {
            int nearest = NONE;
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i < points.length; i++) {
                int cell = points[i] % frame.size();
                double dx = frame.centreX(frame.col(cell)) - hold.x();
                double dy = frame.centreY(frame.row(cell)) - hold.y();
                if (dx * dx + dy * dy < least) {
                    least = dx * dx + dy * dy;
                    nearest = i;
                }
            }
            if (nearest >= 0) {
                leaders[nearest] = nearest;
            }
        }
    }

    /** Returns the ascending trigger points; the array itself. */
    int[] points() {
        return points;
    }

    /** Returns the place of a configuration among the points, negative if it is none. Cost O(log points). */
    int find(int configuration) {
        return Arrays.binarySearch(points, configuration);
    }

    /** Returns the leader of a point, {@link #NONE} or {@link #UNKNOWN}. */
    int leader(int point) {
        return leaders[point];
    }

    void setLeader(int point, int leader) {
        leaders[point] = leader;
    }

    /** Returns the number of the attempt of a leader, {@link #NONE} or {@link #UNKNOWN}. */
    int attempt(int leader) {
        return attempts[leader];
    }

    /**
     * Returns the points that must be known before it can be told which attempts begin at some of them: all points
     * where one of these has no leader yet, else their leaders whose attempt has not been made.
     */
    int[] undecided(IntPredicate asked) {
        int[] here = IntStream.range(0, points.length)
                .filter(i -> asked.test(points[i]))
                .toArray();
        if (Arrays.stream(here).anyMatch(i -> leaders[i] == UNKNOWN)) {
            return points;
        }
        return Arrays.stream(here)
                .map(i -> leaders[i])
                .filter(leader -> leader >= 0 && attempts[leader] == UNKNOWN)
                .distinct()
                .map(leader -> points[leader])
                .toArray();
    }

    void setAttempt(int leader, int attempt) {
        attempts[leader] = attempt;
    }
}
