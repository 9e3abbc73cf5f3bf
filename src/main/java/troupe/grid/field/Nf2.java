package troupe.grid.field;

import java.util.Arrays;
import troupe.grid.region.Region;
import troupe.grid.region.StepRelation;
import troupe.scene.Journey;
import troupe.search.MinHeap;

/**
 * Computes the NF2 skeleton and potential of a region: descending the potential from anywhere leads down to
 * the skeleton, the curve that keeps as far from the region's ends as it can, and along it to the goal.
 *
 * <p>The fronts depend on the region only and are grown once, by the constructor; {@link #compute} thins the
 * region to the skeleton, with a branch to the goal that climbs away from obstacles, and spreads the
 * potential, first along the skeleton, then from all of it at once to the rest, ring by ring, each configuration one wave above one that reached it. Beside the skeleton it is the highest
 * neighbour on the skeleton that counts, so the skeleton lies lower than its sides everywhere. Every reached
 * configuration but the goal has a neighbour one wave lower; there is no other local minimum.
 *
 * <p>Fields cover spans and crossings and follow links between sheets; costs and counters are ignored. Use
 * by one thread at a time. Cost: linear in the region.
 *
 * <p>Sources: Crowd section 3.3; Unified section 6.3; Latombe, chapter 7. Deviations: see {@code docs/fields.md}.
 */
public final class Nf2 {
    /** The potential of places from which no legal way leads to the goal. */
    public static final double UNREACHABLE = Double.POSITIVE_INFINITY;

    private final StepRelation steps;
    private final StepGraph graph;
    private final Brushfire fire;
    private final Skeleton skeleton;
    private final double cell;
    private final int[] waves;
    private final int[] queue;
    private int goal = -1;
    private int folded = -1;

    /** Grows the fronts of a region. */
    public Nf2(Region region) {
        this((StepRelation) region);
    }

    Nf2(StepRelation steps) {
        this.steps = steps;
        this.graph = new StepGraph(steps);
        this.fire = new Brushfire(graph);
        this.cell = steps.frame().cell();
        this.waves = new int[graph.size];
        this.queue = new int[graph.size + 1];
        fire.compute();
        this.skeleton = new Skeleton(graph, fire);
        Arrays.fill(waves, -1);
    }

    /**
     * Finds the skeleton and spreads the potential from the goal; replaces what an earlier call left.
     *
     * @param goal an open configuration
     * @param spread the order along the skeleton: one wave after the other, or widest place first
     * @return this
     * @throws IllegalArgumentException if the goal is not open
     */
    public Nf2 compute(int goal, Journey.Spread spread) {
        requireOpen(steps, goal);
        this.goal = goal;
        this.folded = (graph.trait[goal] & StepGraph.FOLDED) != 0 ? goal : -1;
        skeleton.compute(folded < 0 ? goal : unfoldedNeighbour(goal));
        Arrays.fill(waves, -1);
        waves[goal] = 0;
        int reached = spread == Journey.Spread.BREADTH ? spreadByBreadth() : spreadByClearance();
        spreadToRings(reached);
        return this;
    }

    /** Returns the goal of the last computation, -1 before the first. */
    public int goal() {
        return goal;
    }

    /** Tells whether a configuration belongs to the skeleton, the goal link included. */
    public boolean skeleton(int q) {
        return skeleton.contains(q) || q == folded;
    }

    /** Tells whether a configuration of the skeleton lies where two fronts meet; the others connect. */
    public boolean ridge(int q) {
        return skeleton.contains(q) && skeleton.isRidge(q);
    }

    /** Returns the potential in metres, waves times the cell: 0 at the goal, {@link #UNREACHABLE} elsewhere. */
    public double potential(int q) {
        return waves[q] < 0 ? UNREACHABLE : waves[q] * cell;
    }

    /** Returns the potential in waves; -1 where it is unreachable. */
    public int waves(int q) {
        return waves[q];
    }

    /**
     * Returns the distance in metres from a configuration to where the region ends, between cell centres, as
     * the fronts found it; 0 where none is open.
     */
    public double distance(int q) {
        return (graph.trait[q] & (StepGraph.OPEN | StepGraph.FOLDED)) == StepGraph.OPEN
                ? Math.sqrt(fire.squaredDistance(q)) * cell
                : 0;
    }

    static void requireOpen(StepRelation steps, int goal) {
        if (goal < 0 || goal >= steps.size() || !steps.open(goal)) {
            throw new IllegalArgumentException(
                    "goal " + goal + "; must be an open configuration in [0, " + steps.size() + ")");
        }
    }

    /** Returns a neighbour of a folded node that is not folded; the node that it was folded for has the same. */
    private int unfoldedNeighbour(int q) {
        int s = graph.slot[q];
        for (int k = graph.first[s]; k < graph.first[s + 1]; k++) {
            if ((graph.trait[graph.target[k]] & StepGraph.FOLDED) == 0) {
                return graph.target[k];
            }
        }
        throw new IllegalStateException("folded configuration " + q + " has no neighbour");
    }

    /** Spreads one wave after the other along the skeleton; the queue ends up in ascending order of waves. */
    private int spreadByBreadth() {
        queue[0] = goal;
        int tail = 1;
        for (int head = 0; head < tail; head++) {
            tail = raiseNeighbours(queue[head], tail);
        }
        return tail;
    }

    private int raiseNeighbours(int q, int tail) {
        Link around = skeleton.neighbours(q);
        int end = tail;
        for (int k = 0; k < around.count(); k++) {
            int next = around.member(k);
            if (waves[next] < 0) {
                waves[next] = waves[q] + 1;
                queue[end++] = next;
            }
        }
        return end;
    }

    /** Spreads from the widest place that is reached, first come first served among equals; sorts the queue. */
    private int spreadByClearance() {
        MinHeap widest = new MinHeap();
        widest.add(goal, 0, 0);
        queue[0] = goal;
        int tail = 1;
        while (!widest.isEmpty()) {
            int from = tail;
            tail = raiseNeighbours(widest.removeFirst(), tail);
            for (int k = from; k < tail; k++) {
                widest.add(queue[k], -fire.squaredDistance(queue[k]), 0);
            }
        }
        sortByWaves(tail);
        return tail;
    }

    private void sortByWaves(int count) {
        int[] place = new int[count + 2];
        for (int k = 0; k < count; k++) {
            place[waves[queue[k]] + 1]++;
        }
        for (int w = 1; w < place.length; w++) {
            place[w] += place[w - 1];
        }
        int[] sorted = new int[count];
        for (int k = 0; k < count; k++) {
            sorted[place[waves[queue[k]]]++] = queue[k];
        }
        System.arraycopy(sorted, 0, queue, 0, count);
    }

    /** Spreads from the skeleton to the rest; its highest cells come first, so that each ring lies above them. */
    private void spreadToRings(int reached) {
        for (int low = 0, high = reached - 1; low < high; low++, high--) {
            int swapped = queue[low];
            queue[low] = queue[high];
            queue[high] = swapped;
        }
        int tail = reached;
        for (int head = 0; head < tail; head++) {
            int q = queue[head];
            int wave = waves[q] + 1;
            if ((graph.trait[q] & StepGraph.PLAIN) != 0) {
                int moves = graph.moves[q];
                if (moves == -1) {
                    tail = ring(q, wave, tail);
                    continue;
                }
                for (int bits = moves & 0xFF; bits != 0; bits &= bits - 1) {
                    tail = raise(q + graph.offset[Integer.numberOfTrailingZeros(bits)], wave, tail);
                }
                continue;
            }
            int s = graph.slot[q];
            for (int k = graph.first[s]; k < graph.first[s + 1]; k++) {
                tail = raise(graph.target[k], wave, tail);
            }
        }
    }

    private int ring(int q, int wave, int tail) {
        int up = graph.offset[1];
        int end = raise(q - up - 1, wave, tail);
        end = raise(q - up, wave, end);
        end = raise(q - up + 1, wave, end);
        end = raise(q - 1, wave, end);
        end = raise(q + 1, wave, end);
        end = raise(q + up - 1, wave, end);
        end = raise(q + up, wave, end);
        return raise(q + up + 1, wave, end);
    }

    /** Gives a place its wave if it has none; written without a branch that depends on it. */
    private int raise(int q, int wave, int tail) {
        int known = waves[q];
        queue[tail] = q;
        waves[q] = known < 0 ? wave : known;
        return tail - (known >> 31);
    }
}
