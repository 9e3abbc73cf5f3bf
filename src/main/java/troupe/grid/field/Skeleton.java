package troupe.grid.field;

import java.util.Arrays;
import troupe.grid.GridFrame;

/**
 * Thins a region to its skeleton: a connected curve in each piece, with a loop around each hole, along the
 * ridge where fronts from different places meet.
 *
 * <p>A node is on the <em>ridge</em> if the origin of a straight neighbour lies far from its own. How far:
 * the front of a straight wall in raster is a chain of arcs whose origins lie up to {@code sqrt(8 d + 4)}
 * cells apart at distance {@code d}, which says nothing about the shape; so they must lie further apart than
 * that, or nearly opposite. Of two such neighbours the one that is nearer to the bisector is taken.
 *
 * <p>Nodes are then taken out by ascending distance as long as they are {@linkplain SimplePoints simple} and
 * not on the ridge (distance-ordered homotopic thinning, Pudney 1998); what remains between stretches of
 * ridge connects them. In the end ridge nodes are thinned, too, except ends. The goal is kept; so the last
 * that is left around it is the way up to the ridge.
 *
 * <p>Deviation from Latombe, chapter 7, where the ridge alone is the skeleton: that is neither connected nor
 * thin on a grid.
 */
final class Skeleton {
    /** Origins no further apart than this, in cells², are the same place. */
    private static final int SAME_PLACE = 8;

    /** Squared ratio of the distance of two origins to the distance of the node at which they count as opposite. */
    private static final double OPPOSITE = 1.7 * 1.7;

    private static final byte IN = 1;
    private static final byte RIDGE = 2;
    private static final byte TESTED = 4;

    private final StepGraph graph;
    private final Brushfire fire;
    private final byte[] state;
    private final Link link;
    private int[] waiting = new int[1 << 8];
    private int waitingCount;

    /** Makes the scratch for a graph whose fronts have run. */
    Skeleton(StepGraph graph, Brushfire fire) {
        this.graph = graph;
        this.fire = fire;
        this.state = new byte[graph.size];
        this.link = new Link(graph);
    }

    /** Thins the region, keeping the goal: the curve that is left from there climbs to the ridge. */
    void compute(int goal) {
        for (int q = 0; q < graph.size; q++) {
            state[q] = (graph.trait[q] & (StepGraph.OPEN | StepGraph.FOLDED)) == StepGraph.OPEN ? IN : 0;
        }
        markRidge();
        thinSides(goal);
        thinRidge(goal);
    }

    /** Tells whether a node belongs to the skeleton, goal link included. */
    boolean contains(int q) {
        return (state[q] & IN) != 0;
    }

    /** Tells whether a node lies where fronts from different places meet; others of the skeleton connect. */
    boolean isRidge(int q) {
        return (state[q] & RIDGE) != 0;
    }

    /** Collects the neighbours of a node within the skeleton. */
    Link neighbours(int q) {
        link.collect(q, state, IN);
        return link;
    }

    private void markRidge() {
        for (int q = 0; q < graph.size; q++) {
            if ((state[q] & IN) == 0) {
                continue;
            }
            if ((graph.trait[q] & StepGraph.PLAIN) != 0) {
                int moves = graph.moves[q];
                if ((moves & 1) != 0) {
                    compare(q, q + 1, 0);
                }
                if ((moves & 2) != 0) {
                    compare(q, q + graph.offset[1], 1);
                }
            } else {
                int s = graph.slot[q];
                for (int k = graph.first[s]; k < graph.first[s + 1] && graph.direction[k] < 2; k++) {
                    if ((state[graph.target[k]] & IN) != 0) {
                        compare(q, graph.target[k], graph.direction[k]);
                    }
                }
            }
        }
    }

    private void compare(int q, int neighbour, int d) {
        int apart = fire.apart(q, neighbour, d);
        boolean narrow = apart == 1 && isNarrow(q, d) && isNarrow(neighbour, d);
        if (apart > SAME_PLACE || narrow) {
            markNearer(q, neighbour, d, apart);
        }
    }

    /** Marks the one of two neighbours that is nearer to the bisector of their origins, if those are far apart. */
    private void markNearer(int q, int neighbour, int d, int apart) {
        int stepX = GridFrame.dx(d);
        int stepY = GridFrame.dy(d);
        int qx = fire.dx(q);
        int qy = fire.dy(q);
        int nx = fire.dx(neighbour) - stepX;
        int ny = fire.dy(neighbour) - stepY;
        int ownDistance = qx * qx + qy * qy;
        int otherDistance = fire.squaredDistance(neighbour);
        double farther = Math.max(ownDistance, otherDistance);
        if (apart == 1 || apart > 8 * Math.sqrt(farther) + 4 || apart > OPPOSITE * farther) {
            int ownExcess = nx * nx + ny * ny - ownDistance;
            int otherExcess = (qx + stepX) * (qx + stepX) + (qy + stepY) * (qy + stepY) - otherDistance;
            state[ownExcess <= otherExcess ? q : neighbour] |= RIDGE;
        }
    }

    /** Tells whether a node lies in a corridor of one cell along direction {@code d}, 0 or 1. */
    private boolean isNarrow(int q, int d) {
        return (graph.moves[q] & (d == 0 ? 0b1010 : 0b0101)) == 0;
    }

    private void thinSides(int goal) {
        int[] order = fire.order();
        for (int k = 0; k < fire.count(); k++) {
            takeSide(order[k], goal);
            while (waitingCount > 0) {
                takeSide(waiting[--waitingCount], goal);
            }
        }
    }

    private void takeSide(int q, int goal) {
        if ((state[q] & (IN | RIDGE)) != IN) {
            return;
        }
        if (q != goal && isSimple(q)) {
            state[q] = 0;
            wake(q, TESTED);
        } else {
            state[q] |= TESTED;
        }
    }

    /** Takes out what has become superfluous, except ends and the goal, by ascending distance. */
    private void thinRidge(int goal) {
        int[] order = fire.order();
        for (int k = 0; k < fire.count(); k++) {
            takeRidge(order[k], goal);
            while (waitingCount > 0) {
                takeRidge(waiting[--waitingCount], goal);
            }
        }
    }

    private void takeRidge(int q, int goal) {
        if ((state[q] & IN) != 0 && q != goal && isSimple(q) && degree(q) > 1) {
            state[q] = 0;
            wake(q, IN);
        }
    }

    private boolean isSimple(int q) {
        if ((graph.trait[q] & StepGraph.IRREGULAR) != 0) {
            link.collect(q, state, IN);
            return link.foldsToPoint();
        }
        return SimplePoints.isSimple(directions(q, IN), graph.moves[q]);
    }

    private int degree(int q) {
        return (graph.trait[q] & StepGraph.IRREGULAR) != 0
                ? link.collect(q, state, IN)
                : Integer.bitCount(directions(q, IN));
    }

    /** Returns the directions of the neighbours with a bit in their state; for nodes that are not irregular. */
    private int directions(int q, int bit) {
        int moves = graph.moves[q];
        if ((graph.trait[q] & StepGraph.PLAIN) == 0) {
            int base = graph.slot[q] * GridFrame.DIRECTIONS;
            int found = 0;
            for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                int neighbour = graph.ring[base + d];
                found |= neighbour >= 0 && (state[neighbour] & bit) != 0 ? 1 << d : 0;
            }
            return found;
        }
        return moves == -1 ? allDirections(q, bit) : someDirections(q, bit, moves & 0xFF);
    }

    private int someDirections(int q, int bit, int moves) {
        int found = 0;
        for (int bits = moves; bits != 0; bits &= bits - 1) {
            int d = Integer.numberOfTrailingZeros(bits);
            found |= (state[q + graph.offset[d]] & bit) != 0 ? 1 << d : 0;
        }
        return found;
    }

    /** Does the same where all eight steps are legal, without a branch. */
    private int allDirections(int q, int bit) {
        int shift = Integer.numberOfTrailingZeros(bit);
        int up = q + graph.offset[1];
        int down = q + graph.offset[3];
        return state[q + 1] >> shift & 1
                | (state[up] >> shift & 1) << 1
                | (state[q - 1] >> shift & 1) << 2
                | (state[down] >> shift & 1) << 3
                | (state[up + 1] >> shift & 1) << 4
                | (state[up - 1] >> shift & 1) << 5
                | (state[down - 1] >> shift & 1) << 6
                | (state[down + 1] >> shift & 1) << 7;
    }

    /** Has the neighbours with a bit in their state tested again. */
    private void wake(int q, int bit) {
        if ((graph.trait[q] & StepGraph.IRREGULAR) != 0) {
            int count = link.collect(q, state, bit);
            for (int k = 0; k < count; k++) {
                wait(link.member(k));
            }
            return;
        }
        boolean plain = (graph.trait[q] & StepGraph.PLAIN) != 0;
        for (int bits = directions(q, bit); bits != 0; bits &= bits - 1) {
            int d = Integer.numberOfTrailingZeros(bits);
            wait(plain ? q + graph.offset[d] : graph.ring[graph.slot[q] * GridFrame.DIRECTIONS + d]);
        }
    }

    private void wait(int q) {
        if (waitingCount == waiting.length) {
            waiting = Arrays.copyOf(waiting, 2 * waitingCount);
        }
        waiting[waitingCount++] = q;
    }
}
