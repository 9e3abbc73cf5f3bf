package troupe.grid;

import java.util.Arrays;

/**
 * Holds the layers of a scene: connected sheets of linked spans that do not lie over themselves. Immutable.
 *
 * <p>Neighbouring spans, of cells that share an edge, are linked if their floors differ by no more than a
 * step and the smallest body in use fits under both ceilings at the higher floor. Layers grow breadth-first
 * (neighbours in the order E, N, W, S) from the first span, by cell and then sheet, that has no layer yet; a
 * span joins unless its cell is already taken in that layer. So layers are numbered by their least (cell,
 * span). Source: Unified section 3; Li and Huang's layered scenes.
 */
public final class Layers {
    private static final int NONE = -1;
    private static final int UNVISITED = -2;

    private final Spans spans;
    private final double stepHeight;
    private final double bodyHeight;
    private final int[] layers;
    private double[] lowest = new double[16];
    private double[] highest = new double[16];
    private int count;

    Layers(Spans spans, double stepHeight, double bodyHeight) {
        this.spans = spans;
        this.stepHeight = stepHeight;
        this.bodyHeight = bodyHeight;
        this.layers = new int[spans.size()];
        new Growth().run();
    }

    /** Returns the number of layers. */
    public int count() {
        return count;
    }

    /** Returns the layer of a span, {@code 0 <= layer < count()}, -1 if there is no such span. */
    public int layer(int span) {
        return layers[span];
    }

    /** Returns the lowest floor of a layer in metres. */
    public double lowest(int layer) {
        return lowest[layer];
    }

    /** Returns the highest floor of a layer in metres. */
    public double highest(int layer) {
        return highest[layer];
    }

    /** Grows the layers one after another; holds what is needed only meanwhile. */
    private final class Growth {
        private final int cells = spans.frame().size();
        private final int cols = spans.frame().cols();
        private final int[] at = spans.columnAt();
        private final int[] queue = new int[spans.size()];

        /** The last layer that took each cell; empty where no cell holds two spans. */
        private final int[] taken = new int[spans.sheets() == 1 ? 0 : cells];

        private int tail;

        void run() {
            Arrays.fill(taken, NONE);
            for (int sheet = 0; sheet < spans.sheets(); sheet++) {
                for (int cell = 0; cell < cells; cell++) {
                    layers[sheet * cells + cell] = spans.level(at[cell], sheet) >= 0 ? UNVISITED : NONE;
                }
            }
            for (int cell = 0; cell < cells; cell++) {
                for (int seed = cell; seed < layers.length; seed += cells) {
                    if (layers[seed] == UNVISITED) {
                        grow(seed, cell);
                    }
                }
            }
        }

        private void grow(int seed, int seedCell) {
            if (count == lowest.length) {
                lowest = Arrays.copyOf(lowest, 2 * count);
                highest = Arrays.copyOf(highest, 2 * count);
            }
            lowest[count] = spans.floor(seed);
            highest[count] = spans.floor(seed);
            tail = 0;
            join(seed, seedCell);
            for (int head = 0; head < tail; head++) {
                int span = queue[head];
                int cell = taken.length == 0 ? span : span % cells;
                visit(span, cell, cell + 1);
                visit(span, cell, cell + cols);
                visit(span, cell, cell - 1);
                visit(span, cell, cell - cols);
            }
            count++;
        }

        /** Lets the span over the cell {@code to} that is linked to {@code span} join. */
        private void visit(int span, int cell, int to) {
            int target = span - cell + to;
            boolean changes = at[to] != at[cell];
            if (changes) {
                int sheet = spans.linked(at[cell], (span - cell) / cells, at[to], stepHeight, bodyHeight);
                if (sheet < 0) {
                    return;
                }
                target = sheet * cells + to;
            }
            if (layers[target] != UNVISITED || taken.length > 0 && taken[to] == count) {
                return;
            }
            if (changes) {
                lowest[count] = Math.min(lowest[count], spans.floor(target));
                highest[count] = Math.max(highest[count], spans.floor(target));
            }
            join(target, to);
        }

        private void join(int span, int cell) {
            layers[span] = count;
            if (taken.length > 0) {
                taken[cell] = count;
            }
            queue[tail++] = span;
        }
    }
}
