package troupe.unified.manipulation;

import java.util.Arrays;
import java.util.BitSet;

/**
 * Keeps what a search knows of the poses that it has reached, in growing columns: a pose has one label, which
 * is changed when the pose gets cheaper. Labels are numbers from 0. Adding costs O(1) amortised.
 */
final class PoseLabels {
    /** Stands for no label. */
    static final int NONE = -1;

    private static final int FIRST = 64;

    private int size;
    private int[] cells = new int[FIRST];
    private int[] headings = new int[FIRST];
    private int[] parents = new int[FIRST];
    private int[] stands = new int[FIRST];
    private long[] costs = new long[FIRST];
    private final BitSet closed = new BitSet(FIRST);

    /** Adds a label for the pose whose centroid lies in a cell of the frame; returns its number. */
    int add(int cell, int heading) {
        if (size == cells.length) {
            int capacity = Math.addExact(size, size);
            cells = Arrays.copyOf(cells, capacity);
            headings = Arrays.copyOf(headings, capacity);
            parents = Arrays.copyOf(parents, capacity);
            stands = Arrays.copyOf(stands, capacity);
            costs = Arrays.copyOf(costs, capacity);
        }
        cells[size] = cell;
        headings[size] = heading;
        return size++;
    }

    /** Sets how a pose is reached: from which label, where the actor stands then, and the cost so far in units. */
    void set(int label, int parent, int stand, long cost) {
        parents[label] = parent;
        stands[label] = stand;
        costs[label] = cost;
    }

    int cell(int label) {
        return cells[label];
    }

    int heading(int label) {
        return headings[label];
    }

    int parent(int label) {
        return parents[label];
    }

    int stand(int label) {
        return stands[label];
    }

    long cost(int label) {
        return costs[label];
    }

    /** Notes that a label has been taken; its cost is the least. Returns whether it was taken before. */
    boolean close(int label) {
        boolean before = closed.get(label);
        closed.set(label);
        return before;
    }
}
