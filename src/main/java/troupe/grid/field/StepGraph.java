package troupe.grid.field;

import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.StepRelation;

/**
 * Lays the legal steps of a region out for kernels. A plain node steps to {@code q + offset[d]} for the
 * directions in its mask. The others, near crossings and links between sheets, own a stretch of a target
 * list and, where each direction has one target at most, a ring of eight.
 *
 * <p>Two nodes over one cell (a span and a crossing over it) make the same place twice, which would give
 * every skeleton a spurious loop. So a crossing whose neighbours are all neighbours of another node of its
 * cell is <em>folded</em>: skeletons are sought without it, and no connection is lost. Fields cover it.
 *
 * <p>A node is <em>irregular</em> if the topology of its neighbourhood cannot be read from its direction
 * mask: several targets in one direction, or a block of four cells of which only one diagonal is legal.
 */
final class StepGraph {
    /** Trait: the node is open. */
    static final byte OPEN = 1;
    /** Trait: all steps are given by the mask and the offsets. */
    static final byte PLAIN = 2;
    /** Trait: the neighbourhood needs the general test. */
    static final byte IRREGULAR = 4;
    /** Trait: another node of the same cell stands for this one in skeletons. */
    static final byte FOLDED = 8;

    final StepRelation steps;
    final int size;
    /** Index step of each direction between plain nodes. */
    final int[] offset;
    /** Directions with a legal step, one bit each; per node. */
    final byte[] moves;
    /** Bits of {@link #OPEN} to {@link #FOLDED}; per node. */
    final byte[] trait;
    /** Open nodes that are not plain, ascending. */
    private final int[] special;
    /** Which stretch of the target list a node owns, -1 for plain nodes; null if all nodes are plain. */
    final int[] slot;
    /** Begin of each slot's stretch, and one more for the end of the last. */
    final int[] first;
    /** Targets of the nodes with a slot, by direction, then number. */
    final int[] target;
    /** Directions that belong to {@link #target}. */
    final byte[] direction;
    /** Unfolded target of each direction, -1 if none; eight per slot; not valid for irregular nodes. */
    final int[] ring;

    /** Reads the region once; cost linear in its size. */
    StepGraph(StepRelation steps) {
        this.steps = steps;
        this.size = steps.size();
        this.offset = steps.frame().offsets();
        this.moves = new byte[size];
        this.trait = new byte[size];
        this.special = readPlain();
        if (special.length == 0) {
            this.slot = null;
            this.first = new int[1];
            this.target = new int[0];
            this.direction = new byte[0];
            this.ring = new int[0];
        } else {
            this.slot = new int[size];
            this.first = new int[special.length + 1];
            this.ring = new int[special.length * GridFrame.DIRECTIONS];
            int[] targets = new int[special.length * GridFrame.DIRECTIONS];
            byte[] directions = new byte[targets.length];
            int[] buffer = new int[Region.MAX_NEIGHBOURS];
            int[] bufferDirections = new int[buffer.length];
            int next = 0;
            int used = 0;
            Arrays.fill(slot, -1);
            for (int q : special) {
                int count = steps.neighbours(q, buffer, bufferDirections);
                if (used + count > targets.length) {
                    targets = Arrays.copyOf(targets, 2 * targets.length + count);
                    directions = Arrays.copyOf(directions, targets.length);
                }
                slot[q] = next;
                first[next++] = used;
                int mask = 0;
                for (int k = 0; k < count; k++) {
                    targets[used] = buffer[k];
                    directions[used++] = (byte) bufferDirections[k];
                    mask |= 1 << bufferDirections[k];
                }
                moves[q] = (byte) mask;
            }
            first[next] = used;
            this.target = targets;
            this.direction = directions;
        }
        if (special.length > 0) {
            fold();
            fillRings();
        }
        markTwistedBlocks();
    }

    /** Tells whether there is a legal step from {@code from} in direction {@code d} to {@code to}. */
    boolean has(int from, int d, int to) {
        if ((moves[from] >> d & 1) == 0) {
            return false;
        }
        if ((trait[from] & PLAIN) != 0) {
            return from + offset[d] == to;
        }
        int s = slot[from];
        for (int k = first[s]; k < first[s + 1]; k++) {
            if (target[k] == to && direction[k] == d) {
                return true;
            }
        }
        return false;
    }

    /** Tells whether two straight steps lead to the corner in the diagonal direction {@code d}. */
    boolean goesRound(int q, int d) {
        int a = d - 4;
        int b = d - 3 & 3;
        return leads(q, a, b) || leads(q, b, a);
    }

    /** Tells whether a step in one direction and then one in another are legal. */
    private boolean leads(int q, int d, int then) {
        if ((trait[q] & PLAIN) != 0) {
            return (moves[q] >> d & 1) != 0 && (moves[q + offset[d]] >> then & 1) != 0;
        }
        int s = slot[q];
        for (int k = first[s]; k < first[s + 1]; k++) {
            if (direction[k] == d && (moves[target[k]] >> then & 1) != 0) {
                return true;
            }
        }
        return false;
    }

    /** Returns the direction that leads back. */
    static int opposite(int d) {
        return d < 4 ? d + 2 & 3 : 4 + (d + 2 & 3);
    }

    /** Tells the same as {@link #has} of nodes that are not folded, once the rings are filled. */
    private boolean leadsTo(int from, int d, int to) {
        if ((trait[from] & PLAIN) != 0) {
            return (moves[from] >> d & 1) != 0 && from + offset[d] == to;
        }
        return ring[slot[from] * GridFrame.DIRECTIONS + d] == to || (trait[from] & IRREGULAR) != 0 && has(from, d, to);
    }

    /** Reads masks and plainness; returns the open nodes that are not plain. */
    private int[] readPlain() {
        int[] special = new int[1 << 8];
        int count = 0;
        for (int q = 0; q < size; q++) {
            if (!steps.open(q)) {
                continue;
            }
            if (steps.plain(q)) {
                trait[q] = OPEN | PLAIN;
                moves[q] = (byte) steps.moves(q);
                continue;
            }
            trait[q] = OPEN;
            if (count == special.length) {
                special = Arrays.copyOf(special, 2 * count);
            }
            special[count++] = q;
        }
        return Arrays.copyOf(special, count);
    }

    /** Folds every node that another node of the same cell dominates; of two equals the later one stays. */
    private void fold() {
        for (int q : special) {
            int s = slot[q];
            if (first[s] == first[s + 1]) {
                continue;
            }
            int neighbour = target[first[s]];
            int back = opposite(direction[first[s]]);
            int t = slot[neighbour];
            for (int k = t < 0 ? 0 : first[t], end = t < 0 ? 0 : first[t + 1]; k < end; k++) {
                int other = target[k];
                if (direction[k] == back && other != q && (trait[other] & FOLDED) == 0 && dominates(other, s)) {
                    trait[q] |= FOLDED;
                    break;
                }
            }
        }
    }

    private boolean dominates(int node, int s) {
        for (int k = first[s]; k < first[s + 1]; k++) {
            if (!has(node, direction[k], target[k])) {
                return false;
            }
        }
        return true;
    }

    private void fillRings() {
        Arrays.fill(ring, -1);
        for (int q : special) {
            int s = slot[q];
            for (int k = first[s]; k < first[s + 1]; k++) {
                if ((trait[target[k]] & FOLDED) != 0) {
                    continue;
                }
                int place = s * GridFrame.DIRECTIONS + direction[k];
                if (ring[place] >= 0) {
                    trait[q] |= IRREGULAR;
                }
                ring[place] = target[k];
            }
        }
    }

    /** Marks the nodes of blocks of four where the diagonals or the way round do not agree. */
    private void markTwistedBlocks() {
        int north = offset[1];
        for (int q = 0; q < size; q++) {
            int traits = trait[q];
            if ((traits & PLAIN) != 0) {
                int mask = moves[q];
                if ((mask & 3) == 3
                        && ((mask >> 4 ^ moves[q + 1] >> 5) & 1) != 0
                        && (trait[q + 1] & trait[q + north] & PLAIN) != 0) {
                    mark(q, q + 1, q + north, q + north + 1);
                }
            } else if (traits == OPEN) {
                checkQuadrants(q);
            }
        }
    }

    private void mark(int a, int b, int c, int d) {
        trait[a] |= IRREGULAR;
        trait[b] |= IRREGULAR;
        trait[c] |= IRREGULAR;
        if ((trait[d] & OPEN) != 0) {
            trait[d] |= IRREGULAR;
        }
    }

    /** Checks that the neighbours of a node with a ring close round each diagonal; marks all four otherwise. */
    private void checkQuadrants(int q) {
        int base = slot[q] * GridFrame.DIRECTIONS;
        for (int d = 4; d < GridFrame.DIRECTIONS; d++) {
            int a = d - 4;
            int b = d - 3 & 3;
            int left = ring[base + a];
            int right = ring[base + b];
            int corner = ring[base + d];
            if (left < 0 || right < 0) {
                if (corner >= 0) {
                    trait[q] |= IRREGULAR;
                }
                continue;
            }
            boolean across = leadsTo(left, 4 + b, right);
            boolean round = corner >= 0 && leadsTo(left, b, corner) && leadsTo(right, a, corner);
            if (across != round || corner >= 0 && !round) {
                mark(q, left, right, corner >= 0 ? corner : q);
            }
        }
    }
}
