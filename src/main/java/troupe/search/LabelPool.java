package troupe.search;

import java.util.Arrays;

/**
 * Keeps the labels of a search in growing columns of primitives. A label is a number from 0 in order of
 * making; it tells a state and which of several spaces the state belongs to, the label it came from, the
 * cost so far, what has been used up of a limit, where something under way began, the number of a task that
 * goes on there, and the next label of the same chain. Labels are never removed one by one. Adding costs O(1)
 * amortised.
 */
public final class LabelPool {
    /** Stands for no label, no beginning and no task. */
    public static final int NONE = -1;

    private int[] spaces;
    private int[] states;
    private int[] parents;
    private int[] nexts;
    private int[] begins;
    private int[] tasks;
    private long[] costs;
    private double[] used;
    private int size;

    /** Makes an empty pool with room for {@code capacity} labels, at least 1, before it grows. */
    public LabelPool(int capacity) {
        if (capacity < 1) {
            throw new IllegalArgumentException("capacity=" + capacity + "; needs at least 1");
        }
        spaces = new int[capacity];
        states = new int[capacity];
        parents = new int[capacity];
        nexts = new int[capacity];
        begins = new int[capacity];
        tasks = new int[capacity];
        costs = new long[capacity];
        used = new double[capacity];
    }

    /** Forgets every label; keeps the memory. */
    public void clear() {
        size = 0;
    }

    /** Returns the number of labels. */
    public int size() {
        return size;
    }

    /**
     * Adds a label without a task and returns its number.
     *
     * @param space the space that the state belongs to
     * @param state what it stands for
     * @param parent the label it came from, or {@link #NONE}
     * @param cost the cost so far
     * @param used how much of a limit is used up
     * @param begin where something under way began, or {@link #NONE}
     * @param next the next label of its chain, or {@link #NONE}
     */
    public int add(int space, int state, int parent, long cost, double used, int begin, int next) {
        if (size == states.length) {
            grow();
        }
        int label = size++;
        spaces[label] = space;
        states[label] = state;
        parents[label] = parent;
        costs[label] = cost;
        this.used[label] = used;
        begins[label] = begin;
        tasks[label] = NONE;
        nexts[label] = next;
        return label;
    }

    private void grow() {
        int capacity = Math.addExact(size, size / 2 + 1);
        spaces = Arrays.copyOf(spaces, capacity);
        states = Arrays.copyOf(states, capacity);
        parents = Arrays.copyOf(parents, capacity);
        nexts = Arrays.copyOf(nexts, capacity);
        begins = Arrays.copyOf(begins, capacity);
        tasks = Arrays.copyOf(tasks, capacity);
        costs = Arrays.copyOf(costs, capacity);
        used = Arrays.copyOf(used, capacity);
    }

    /** Returns the space of a label's state. */
    public int space(int label) {
        return spaces[label];
    }

    /** Returns the number of the task that goes on at a label, or {@link #NONE}. */
    public int task(int label) {
        return tasks[label];
    }

    /** Sets the task that goes on at a label. */
    public void setTask(int label, int task) {
        tasks[label] = task;
    }

    /** Returns the state of a label. */
    public int state(int label) {
        return states[label];
    }

    /** Returns the label that a label came from, or {@link #NONE}. */
    public int parent(int label) {
        return parents[label];
    }

    /** Returns the cost so far of a label. */
    public long cost(int label) {
        return costs[label];
    }

    /** Returns how much of a limit a label has used up. */
    public double used(int label) {
        return used[label];
    }

    /** Returns where that which is under way at a label began, or {@link #NONE}. */
    public int begin(int label) {
        return begins[label];
    }

    /** Returns the next label of a label's chain, or {@link #NONE}. */
    public int next(int label) {
        return nexts[label];
    }

    /** Sets the next label of a label's chain. */
    public void setNext(int label, int next) {
        nexts[label] = next;
    }
}
