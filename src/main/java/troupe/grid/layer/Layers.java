package troupe.grid.layer;

import java.util.Arrays;
import java.util.BitSet;
import troupe.grid.CellRuns;
import troupe.scene.Obstacle;

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

    private final Spans spans;
    private final double stepHeight;
    private final double bodyHeight;
    private final int[] layers;
    private double[] lowest = new double[16];
    private double[] highest = new double[16];
    private int count;

    /** Prepares the layers of spans between which a body of so many metres steps up or down at most so many. */
    public Layers(Spans spans, double stepHeight, double bodyHeight) {
        this.spans = spans;
        this.stepHeight = stepHeight;
        this.bodyHeight = bodyHeight;
        this.layers = new int[spans.size()];
        new Numbering().run();
    }

    /** Returns the number of layers. */
    public int count() {
        return count;
    }

    /** Returns the layer of a span, {@code 0 <= layer < count()}, -1 if there is no such span. */
    public int layer(int span) {
        return layers[span];
    }

    /**
     * Returns the layer that an obstacle's bottom rests on: of the spans whose floor is at its offset, over the
     * cells that it covers (where there are none, those within a cell of its outline), the layer of most of
     * them, ties the least; -1 if it rests on none. Cost O(cells of its box).
     */
    public int of(Obstacle obstacle) {
        int[] votes = new int[count];
        CellRuns runs = new CellRuns(spans.frame());
        runs.fill(obstacle.outline());
        int best = best(obstacle, runs, votes);
        if (best < 0) {
            runs.clear();
            runs.near(obstacle.outline(), spans.frame().cell());
            best = best(obstacle, runs, votes);
        }
        return best;
    }

    private int best(Obstacle obstacle, CellRuns runs, int[] votes) {
        BitSet under = new BitSet();
        for (int i = 0; i < runs.size(); i++) {
            under.set(runs.from(i), runs.to(i));
        }
        for (int cell = under.nextSetBit(0); cell >= 0; cell = under.nextSetBit(cell + 1)) {
            for (int span = cell; span < layers.length; span += spans.frame().size()) {
                if (layers[span] >= 0 && Math.abs(spans.floor(span) - obstacle.offset()) <= Column.SAME) {
                    votes[layers[span]]++;
                }
            }
        }
        int best = -1;
        for (int layer = 0; layer < votes.length; layer++) {
            if (votes[layer] > (best < 0 ? 0 : votes[best])) {
                best = layer;
            }
        }
        return best;
    }

    /** Returns the lowest floor of a layer in metres. */
    public double lowest(int layer) {
        return lowest[layer];
    }

    /** Returns the highest floor of a layer in metres. */
    public double highest(int layer) {
        return highest[layer];
    }

    /**
     * Numbers the layers; holds what is needed only meanwhile. Pieces that hang together and lie over no
     * cell twice are layers as they are; only others are grown span by span.
     */
    private final class Numbering {
        private final int cells = spans.frame().size();
        private final int cols = spans.frame().cols();
        private final int[] at = spans.columnAt();
        private final int sheets = spans.sheets();
        private final LinkedStretches stretches = new LinkedStretches(spans, stepHeight, bodyHeight);
        private final boolean[] overlapping = stretches.overlapping();
        private final int[] layerOf = new int[overlapping.length];
        private int[] queue = {};

        /** The last layer that took each cell; empty until a layer has to be grown. */
        private int[] taken = {};

        private int tail;

        void run() {
            Arrays.fill(layers, NONE);
            for (int segment = 0; segment < stretches.segments(); segment++) {
                boolean grows = false;
                for (int sheet = 0; sheet < sheets; sheet++) {
                    grows |= overlapping[stretches.root(segment * sheets + sheet)];
                }
                int last = grows ? stretches.start(segment + 1) - 1 : stretches.start(segment);
                for (int cell = stretches.start(segment); cell <= last; cell++) {
                    number(segment, cell);
                }
            }
        }

        /** Numbers, at the first cell of a segment, its whole stretches, and at each cell spans that have to be grown. */
        private void number(int segment, int cell) {
            int column = stretches.column(segment);
            for (int sheet = 0; sheet < sheets && spans.level(column, sheet) >= 0; sheet++) {
                int stretch = segment * sheets + sheet;
                int root = stretches.root(stretch);
                if (overlapping[root]) {
                    if (layers[sheet * cells + cell] == NONE) {
                        grow(sheet * cells + cell, cell);
                    }
                } else if (cell == stretches.start(segment)) {
                    if (root == stretch) {
                        layerOf[root] = begin();
                    }
                    int base = sheet * cells;
                    Arrays.fill(layers, base + cell, base + stretches.start(segment + 1), layerOf[root]);
                    extend(layerOf[root], spans.floor(column, sheet));
                }
            }
        }

        /** Begins a layer; returns its number. */
        private int begin() {
            if (count == lowest.length) {
                lowest = Arrays.copyOf(lowest, 2 * count);
                highest = Arrays.copyOf(highest, 2 * count);
            }
            lowest[count] = Double.POSITIVE_INFINITY;
            highest[count] = Double.NEGATIVE_INFINITY;
            return count++;
        }

        private void extend(int layer, double floor) {
            lowest[layer] = Math.min(lowest[layer], floor);
            highest[layer] = Math.max(highest[layer], floor);
        }

        private void grow(int seed, int seedCell) {
            if (taken.length == 0) {
                taken = new int[cells];
                Arrays.fill(taken, NONE);
                queue = new int[spans.size()];
            }
            int layer = begin();
            tail = 0;
            enqueue(seed, seedCell, layer);
            for (int head = 0; head < tail; head++) {
                int span = queue[head];
                int cell = span % cells;
                visit(span, cell, cell + 1, layer);
                visit(span, cell, cell + cols, layer);
                visit(span, cell, cell - 1, layer);
                visit(span, cell, cell - cols, layer);
            }
        }

        /** Lets the span over the cell {@code to} that is linked to {@code span} join. */
        private void visit(int span, int cell, int to, int layer) {
            int target = span - cell + to;
            if (at[to] != at[cell]) {
                int sheet = spans.linked(at[cell], (span - cell) / cells, at[to], stepHeight, bodyHeight);
                if (sheet < 0) {
                    return;
                }
                target = sheet * cells + to;
            }
            if (layers[target] == NONE && taken[to] != layer) {
                enqueue(target, to, layer);
            }
        }

        private void enqueue(int span, int cell, int layer) {
            layers[span] = layer;
            extend(layer, spans.floor(at[cell], (span - cell) / cells));
            taken[cell] = layer;
            queue[tail++] = span;
        }
    }
}
