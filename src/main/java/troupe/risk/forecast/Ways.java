package troupe.risk.forecast;

import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.search.BucketQueue;

/**
 * Knows which ways lead round the walls: a coarse grid over the ground, its cells joined where the straight line
 * between their middles is free. Immutable but for the scratch of {@link #flood}; used by one thread at a time.
 *
 * <p>A block of cells stands at the open cell nearest to its middle; a block without one is solid.
 */
public final class Ways {
    /** The edge of a block in metres, about. */
    private static final double BLOCK = 0.2;
    /** Costs of a straight and of a diagonal step between blocks. */
    private static final int STRAIGHT = 5;

    private static final int DIAGONAL = 7;
    /** The distance of a block that was not reached. */
    static final int FAR = Integer.MAX_VALUE;

    private final GridFrame fine;
    private final boolean[] ground;
    private final int factor;
    private final int cols;
    private final int rows;
    private final int[] stand;
    private final byte[] links;
    private final int[] solidBefore;
    private final BucketQueue open = new BucketQueue(0);

    /**
     * Surveys the ground of a region, that of a walker without extent. Cost O(cells).
     *
     * @param region whose lowest floors are the ground
     */
    public Ways(Region region) {
        this.fine = region.frame();
        this.ground = ground(region);
        this.factor = (int) Math.max(1, Math.round(BLOCK / fine.cell()));
        this.cols = (fine.cols() + factor - 1) / factor;
        this.rows = (fine.rows() + factor - 1) / factor;
        this.stand = new int[cols * rows];
        this.links = new byte[cols * rows];
        this.solidBefore = new int[(cols + 1) * (rows + 1)];
        for (int block = 0; block < stand.length; block++) {
            stand[block] = standing(block);
        }
        for (int block = 0; block < stand.length; block++) {
            links[block] = (byte) links(block);
        }
        count();
    }

    /** Finds the cells that belong to the ground: joined by steps to a floor no higher than a step. */
    private static boolean[] ground(Region region) {
        int cells = region.frame().size();
        boolean[] ground = new boolean[cells];
        int[] queue = new int[cells];
        int tail = 0;
        for (int cell = 0; cell < cells; cell++) {
            if (region.open(cell) && region.elevation(cell) <= region.actor().stepHeight()) {
                ground[cell] = true;
                queue[tail++] = cell;
            }
        }
        int[] offsets = region.frame().offsets();
        for (int head = 0; head < tail; head++) {
            for (int moves = region.moves(queue[head]); moves != 0; moves &= moves - 1) {
                int next = queue[head] + offsets[Integer.numberOfTrailingZeros(moves)];
                if (next < cells && !ground[next]) {
                    ground[next] = true;
                    queue[tail++] = next;
                }
            }
        }
        return ground;
    }

    private int standing(int block) {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        int col = block % cols * factor;
        int row = block / cols * factor;
        double middle = (factor - 1) / 2.0;
        for (int r = 0; r < factor && row + r < fine.rows(); r++) {
            for (int c = 0; c < factor && col + c < fine.cols(); c++) {
                double away = (r - middle) * (r - middle) + (c - middle) * (c - middle);
                int cell = fine.index(col + c, row + r);
                if (away < least && ground[cell]) {
                    least = away;
                    best = cell;
                }
            }
        }
        return best;
    }

    private int links(int block) {
        int mask = 0;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            int col = block % cols + GridFrame.dx(d);
            int row = block / cols + GridFrame.dy(d);
            boolean inside = col >= 0 && row >= 0 && col < cols && row < rows;
            if (inside && joined(stand[block], stand[row * cols + col])) {
                mask |= 1 << d;
            }
        }
        return mask;
    }

    private boolean joined(int from, int to) {
        if (from < 0 || to < 0) {
            return false;
        }
        int dx = fine.col(to) - fine.col(from);
        int dy = fine.row(to) - fine.row(from);
        int steps = Math.max(Math.abs(dx), Math.abs(dy));
        for (int k = 0; k <= steps; k++) {
            int col = fine.col(from) + (int) Math.round((double) dx * k / steps);
            int row = fine.row(from) + (int) Math.round((double) dy * k / steps);
            if (!ground[fine.index(col, row)]) {
                return false;
            }
        }
        return true;
    }

    /** Counts for each block how many are not wholly open below and left of it. */
    private void count() {
        for (int row = 0; row < rows; row++) {
            int line = 0;
            for (int col = 0; col < cols; col++) {
                line += wholly(row * cols + col) ? 0 : 1;
                solidBefore[(row + 1) * (cols + 1) + col + 1] = solidBefore[row * (cols + 1) + col + 1] + line;
            }
        }
    }

    private boolean wholly(int block) {
        int col = block % cols * factor;
        int row = block / cols * factor;
        for (int r = row; r < row + factor; r++) {
            for (int c = col; c < col + factor; c++) {
                if (r >= fine.rows() || c >= fine.cols() || !ground[fine.index(c, r)]) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Returns the number of blocks. */
    public int size() {
        return stand.length;
    }

    /** Returns the edge of a block in metres. */
    double edge() {
        return factor * fine.cell();
    }

    /** Returns the block that holds a place, -1 outside. */
    int block(double x, double y) {
        int col = Math.floorDiv(fine.colAt(x), factor);
        int row = Math.floorDiv(fine.rowAt(y), factor);
        return col < 0 || row < 0 || col >= cols || row >= rows ? -1 : row * cols + col;
    }

    /** Tells whether a place is no wall: an open cell of the ground. */
    boolean free(double x, double y) {
        int cell = fine.cellAt(x, y);
        return cell >= 0 && ground[cell];
    }

    /** Returns the frame of the ground's cells. */
    public GridFrame frame() {
        return fine;
    }

    /** Tells whether a cell of the ground is no wall. */
    public boolean isFree(int cell) {
        return ground[cell];
    }

    /** Tells whether everything within {@code radius} metres of a place is free, judged by the square around. */
    boolean clear(double x, double y, double radius) {
        int low = Math.floorDiv(fine.colAt(x - radius), factor);
        int high = Math.floorDiv(fine.colAt(x + radius), factor) + 1;
        int bottom = Math.floorDiv(fine.rowAt(y - radius), factor);
        int top = Math.floorDiv(fine.rowAt(y + radius), factor) + 1;
        if (low < 0 || bottom < 0 || high > cols || top > rows) {
            return false;
        }
        int wide = cols + 1;
        return solidBefore[top * wide + high]
                        - solidBefore[bottom * wide + high]
                        - solidBefore[top * wide + low]
                        + solidBefore[bottom * wide + low]
                == 0;
    }

    /** Returns the x in metres where a block stands; NaN if it is solid. */
    double standX(int block) {
        return stand[block] < 0 ? Double.NaN : fine.centreX(fine.col(stand[block]));
    }

    /** Returns the y in metres where a block stands; NaN if it is solid. */
    double standY(int block) {
        return stand[block] < 0 ? Double.NaN : fine.centreY(fine.row(stand[block]));
    }

    /**
     * Finds the shortest ways from a block over at most {@code most} metres, in fifths of a block's edge;
     * {@link #FAR} beyond. From a solid block it begins at its open neighbours. Cost O(blocks reached), and O(blocks)
     * to fill the array.
     */
    void flood(int from, double most, int[] distance) {
        Arrays.fill(distance, FAR);
        if (from < 0) {
            return;
        }
        open.clear();
        distance[from] = 0;
        open.add(from, 0, 0);
        double limit = most / edge() * STRAIGHT;
        while (!open.isEmpty()) {
            long key = open.firstKey();
            int block = open.removeFirst();
            if (key != distance[block]) {
                continue;
            }
            boolean solid = stand[block] < 0;
            for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                int col = block % cols + GridFrame.dx(d);
                int row = block / cols + GridFrame.dy(d);
                if (col < 0 || row < 0 || col >= cols || row >= rows) {
                    continue;
                }
                int next = row * cols + col;
                boolean leads = solid ? stand[next] >= 0 : (links[block] >> d & 1) != 0;
                int cost = distance[block] + (d < 4 ? STRAIGHT : DIAGONAL);
                if (leads && cost < distance[next] && cost <= limit) {
                    distance[next] = cost;
                    open.add(next, cost, 0);
                }
            }
        }
    }

    /** Returns a distance of {@link #flood} in metres. */
    double metres(int distance) {
        return distance == FAR ? Double.POSITIVE_INFINITY : distance * edge() / STRAIGHT;
    }
}
