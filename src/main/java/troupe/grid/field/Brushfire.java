package troupe.grid.field;

import java.util.Arrays;
import troupe.grid.GridFrame;

/**
 * Grows wavefronts from wherever the region ends, each carrying its origin, and records for every unfolded
 * node how far and which way the origin of the front that reached it first lies. The origin of a node at
 * the end of the region is the centre of the neighbouring cell that is missing; distances are Euclidean,
 * between cell centres, but fronts travel over legal steps, so each level of a layered scene has its own.
 *
 * <p>Fronts advance in bands of half a cell, in each band first come, first served; a node sends its origin
 * only onwards, to the straight neighbours that lie further from it. Cost: a few steps per node, whatever the
 * shape.
 *
 * <p>Source: Crowd section 3.3; Latombe, chapter 7; vector propagation after Danielsson (1980), ordered
 * as by Cuisenaire &amp; Macq (1999). Propagation along rows and columns only can miss the nearest origin where
 * three fronts meet, by a small part of a cell.
 */
final class Brushfire {
    private static final int BIAS = 0x4000;
    private static final int RIGHT = 1 << 15;
    private static final int LOW = 0x7FFF;
    private static final int DONE = 1 << 30;
    private static final int BANDS = 4;

    private final StepGraph graph;
    private final int[] change = new int[GridFrame.DIRECTIONS];
    private final int[][] band = new int[BANDS][1 << 10];
    private final int[] length = new int[BANDS];
    private final int[] vector;
    private final int[] squared;
    private final int[] order;
    private int count;

    /** Makes the scratch for one graph. */
    Brushfire(StepGraph graph) {
        this.graph = graph;
        this.vector = new int[graph.size];
        this.squared = new int[graph.size];
        this.order = new int[graph.size];
        for (int d = 0; d < change.length; d++) {
            change[d] = (GridFrame.dx(d) << 15) + GridFrame.dy(d);
        }
    }

    /** Runs the fronts until they have met everywhere. */
    void compute() {
        Arrays.fill(squared, Integer.MAX_VALUE);
        count = 0;
        int open = seed();
        for (int current = 2, quiet = 0; quiet < BANDS; current++) {
            int b = current & BANDS - 1;
            quiet = length[b] == 0 ? quiet + 1 : 0;
            for (int k = 0; k < length[b]; k++) {
                int q = band[b][k];
                if (4 * squared[q] < current * current) {
                    continue;
                }
                if ((vector[q] & DONE) == 0) {
                    vector[q] |= DONE;
                    order[count++] = q;
                }
                spread(q, current);
            }
            length[b] = 0;
        }
        if (count < open) {
            fillPockets();
        }
    }

    /** Returns the nodes by ascending distance, to half a cell; {@link #count} of them are valid. */
    int[] order() {
        return order;
    }

    /** Returns how many nodes the fronts reached: all that are open and not folded. */
    int count() {
        return count;
    }

    /** Returns how far to the right of its origin a node lies, in cells. */
    int dx(int q) {
        return (vector[q] >>> 15 & LOW) - BIAS;
    }

    /** Returns how far above its origin a node lies, in cells. */
    int dy(int q) {
        return (vector[q] & LOW) - BIAS;
    }

    /** Returns the squared distance of a node to its origin, in cells². */
    int squaredDistance(int q) {
        return squared[q];
    }

    private static int squared(int v) {
        int dx = (v >>> 15 & LOW) - BIAS;
        int dy = (v & LOW) - BIAS;
        return dx * dx + dy * dy;
    }

    /** Returns the squared distance in cells² of the origins of a node and its neighbour in direction {@code d}. */
    int apart(int q, int neighbour, int d) {
        int shift = vector[neighbour] - vector[q] - change[d];
        int dy = shift << 17 >> 17;
        int dx = shift - dy >> 15;
        return dx * dx + dy * dy;
    }

    /** Gives the nodes at the region's end the nearest missing cell as origin; returns how many nodes there are. */
    private int seed() {
        int open = 0;
        for (int q = 0; q < graph.size; q++) {
            if ((graph.trait[q] & (StepGraph.OPEN | StepGraph.FOLDED)) != StepGraph.OPEN) {
                continue;
            }
            open++;
            int d = graph.moves[q] == -1 ? -1 : end(q);
            if (d >= 0) {
                vector[q] = (BIAS - GridFrame.dx(d) << 15) + BIAS - GridFrame.dy(d);
                squared[q] = d < 4 ? 1 : 2;
                push(2, q);
            }
        }
        return open;
    }

    /** Returns the first direction in which the region ends next to a node, straight ones first; -1 if none. */
    private int end(int q) {
        int missing = ~graph.moves[q] & 0xFF;
        for (int bits = missing; bits != 0; bits &= bits - 1) {
            int d = Integer.numberOfTrailingZeros(bits);
            if (d < 4 || !graph.goesRound(q, d)) {
                return d;
            }
        }
        return -1;
    }

    private void spread(int q, int current) {
        int v = vector[q] & ~DONE;
        int dx = (v >>> 15) - BIAS;
        int dy = (v & LOW) - BIAS;
        int distance = squared[q] + 1;
        if ((graph.trait[q] & StepGraph.PLAIN) == 0) {
            spreadByList(q, v, current);
            return;
        }
        int right = dx < 0 ? -1 : 1;
        int up = dy < 0 ? -1 : 1;
        int moves = graph.moves[q];
        if (moves == -1) {
            offer(q + right, v + right * RIGHT, distance + 2 * right * dx, current);
            offer(q + up * graph.offset[1], v + up, distance + 2 * up * dy, current);
        } else {
            spreadWithin(q, v, distance, moves, current);
            return;
        }
        if (dx == 0) {
            offer(q - 1, v - RIGHT, distance, current);
        }
        if (dy == 0) {
            offer(q - graph.offset[1], v - 1, distance, current);
        }
    }

    private void spreadWithin(int q, int v, int distance, int moves, int current) {
        int dx = (v >>> 15) - BIAS;
        int dy = (v & LOW) - BIAS;
        if (dx >= 0 && (moves & 1) != 0) {
            offer(q + 1, v + RIGHT, distance + 2 * dx, current);
        }
        if (dx <= 0 && (moves & 4) != 0) {
            offer(q - 1, v - RIGHT, distance - 2 * dx, current);
        }
        if (dy >= 0 && (moves & 2) != 0) {
            offer(q + graph.offset[1], v + 1, distance + 2 * dy, current);
        }
        if (dy <= 0 && (moves & 8) != 0) {
            offer(q + graph.offset[3], v - 1, distance - 2 * dy, current);
        }
    }

    private void spreadByList(int q, int v, int current) {
        int dx = (v >>> 15) - BIAS;
        int dy = (v & LOW) - BIAS;
        int s = graph.slot[q];
        for (int k = graph.first[s]; k < graph.first[s + 1] && graph.direction[k] < 4; k++) {
            int d = graph.direction[k];
            int along = dx * GridFrame.dx(d) + dy * GridFrame.dy(d);
            if (along >= 0 && (graph.trait[graph.target[k]] & StepGraph.FOLDED) == 0) {
                offer(graph.target[k], v + change[d], squared[q] + 2 * along + 1, current);
            }
        }
    }

    /**
     * Takes an offered origin if it is nearer; a straight step leads at most two bands on. Written without
     * branches, because which offers are taken cannot be foretold.
     */
    private void offer(int q, int v, int distance, int current) {
        int known = squared[q];
        int old = vector[q];
        int taken = distance - known >>> 31;
        squared[q] = Math.min(distance, known);
        vector[q] = taken != 0 ? v | old & DONE : old;
        int beyond = (current + 1) * (current + 1) - 1 - 4 * distance >>> 31;
        int farBeyond = (current + 2) * (current + 2) - 1 - 4 * distance >>> 31;
        int b = current + beyond + farBeyond & BANDS - 1;
        int at = length[b];
        band[b][at] = q;
        length[b] = at + taken;
        if (at + taken == band[b].length) {
            band[b] = Arrays.copyOf(band[b], 2 * band[b].length);
        }
    }

    private void push(int bandNumber, int q) {
        int b = bandNumber & BANDS - 1;
        band[b][length[b]++] = q;
        if (length[b] == band[b].length) {
            band[b] = Arrays.copyOf(band[b], 2 * length[b]);
        }
    }

    /** Reaches nodes that lie onwards of none of their neighbours; only bent surfaces have such. */
    private void fillPockets() {
        for (int before = -1; before != count; ) {
            before = count;
            for (int k = 0; k < count; k++) {
                int v = vector[order[k]] & ~DONE;
                int s = graph.slot[order[k]];
                for (int e = s < 0 ? 0 : graph.first[s], end = s < 0 ? 0 : graph.first[s + 1]; e < end; e++) {
                    reach(graph.target[e], v + change[graph.direction[e]]);
                }
                for (int d = 0; s < 0 && d < change.length; d++) {
                    if ((graph.moves[order[k]] >> d & 1) != 0) {
                        reach(order[k] + graph.offset[d], v + change[d]);
                    }
                }
            }
        }
    }

    private void reach(int q, int v) {
        if (squared[q] == Integer.MAX_VALUE && (graph.trait[q] & StepGraph.FOLDED) == 0) {
            vector[q] = v | DONE;
            squared[q] = squared(v);
            order[count++] = q;
        }
    }
}
