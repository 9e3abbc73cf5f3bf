package troupe.unified.search;

import java.util.Arrays;

/**
 * Finds least-cost ways over a plain grid: A* on bare arrays with the octile distance and buckets of an
 * eighth of a step, each a stack; a place is expanded again when it is reached more cheaply. It knows
 * nothing but free and blocked cells, and is what the planner's speed is measured against.
 */
public final class PlainAStar {
    private static final double ROOT = Math.sqrt(2);
    private static final double PER_STEP = 8;

    private final int cols;
    private final boolean[] free;
    private final double[] costs;
    private final int[] stamps;
    private final int[] expandedAt;
    private final double[] expandedCost;
    private final int[] offsets;
    private int[][] buckets = new int[1024][];
    private int[] counts = new int[1024];
    private int generation;
    private long expanded;

    /** Makes a search over cells, row-major, with a border of blocked ones. */
    public PlainAStar(boolean[] free, int cols) {
        this.free = free;
        this.cols = cols;
        costs = new double[free.length];
        stamps = new int[free.length];
        expandedAt = new int[free.length];
        expandedCost = new double[free.length];
        offsets = new int[] {1, cols, -1, -cols, cols + 1, cols - 1, -cols - 1, -cols + 1};
    }

    /** Returns the places expanded by the last call. */
    public long expanded() {
        return expanded;
    }

    /** Returns the length of a shortest way in cells, infinite if there is none. */
    public double length(int start, int goal) {
        generation++;
        expanded = 0;
        Arrays.fill(counts, 0);
        int goalCol = goal % cols;
        int goalRow = goal / cols;
        stamps[start] = generation;
        costs[start] = 0;
        push(start, octile(start % cols, start / cols, goalCol, goalRow));
        for (int bucket = 0; bucket < counts.length; bucket++) {
            while (counts[bucket] > 0) {
                int at = buckets[bucket][--counts[bucket]];
                double cost = costs[at];
                if (expandedAt[at] == generation && expandedCost[at] <= cost) {
                    continue;
                }
                if (at == goal) {
                    return cost;
                }
                expandedAt[at] = generation;
                expandedCost[at] = cost;
                expanded++;
                int row = at / cols;
                int col = at - row * cols;
                boolean e = reach(at, 0, cost + 1, col + 1, row, goalCol, goalRow);
                boolean n = reach(at, 1, cost + 1, col, row + 1, goalCol, goalRow);
                boolean w = reach(at, 2, cost + 1, col - 1, row, goalCol, goalRow);
                boolean s = reach(at, 3, cost + 1, col, row - 1, goalCol, goalRow);
                if (e && n) {
                    reach(at, 4, cost + ROOT, col + 1, row + 1, goalCol, goalRow);
                }
                if (n && w) {
                    reach(at, 5, cost + ROOT, col - 1, row + 1, goalCol, goalRow);
                }
                if (w && s) {
                    reach(at, 6, cost + ROOT, col - 1, row - 1, goalCol, goalRow);
                }
                if (s && e) {
                    reach(at, 7, cost + ROOT, col + 1, row - 1, goalCol, goalRow);
                }
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    private boolean reach(int from, int direction, double cost, int col, int row, int goalCol, int goalRow) {
        int to = from + offsets[direction];
        if (!free[to]) {
            return false;
        }
        if (stamps[to] != generation || cost < costs[to] - 1e-9) {
            stamps[to] = generation;
            costs[to] = cost;
            push(to, cost + octile(col, row, goalCol, goalRow));
        }
        return true;
    }

    private void push(int cell, double key) {
        int bucket = (int) (key * PER_STEP + 1e-6);
        if (bucket >= counts.length) {
            buckets = Arrays.copyOf(buckets, Math.max(bucket + 1, 2 * buckets.length));
            counts = Arrays.copyOf(counts, buckets.length);
        }
        if (buckets[bucket] == null) {
            buckets[bucket] = new int[32];
        } else if (counts[bucket] == buckets[bucket].length) {
            buckets[bucket] = Arrays.copyOf(buckets[bucket], 2 * counts[bucket]);
        }
        buckets[bucket][counts[bucket]++] = cell;
    }

    private static double octile(int col, int row, int goalCol, int goalRow) {
        int dx = Math.abs(col - goalCol);
        int dy = Math.abs(row - goalRow);
        return Math.max(dx, dy) + (ROOT - 1) * Math.min(dx, dy);
    }
}
