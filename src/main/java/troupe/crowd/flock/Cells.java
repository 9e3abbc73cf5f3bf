package troupe.crowd.flock;

import java.util.Arrays;

/**
 * Sorts the agents of one step by the cell of a plain grid, half the view distance wide, so that the neighbours of
 * an agent lie in five runs of consecutive places. Agents keep the order of their numbers within a cell. The arrays
 * are indexed by place. Cost O(agents + cells) for each {@link #sort}.
 */
final class Cells {
    /** Cells of the widest world are made larger rather than more than this. */
    private static final int MOST_CELLS = 1 << 20;

    /** How many cells to each side hold all neighbours. */
    static final int REACH = 2;

    /** How many numbers of {@link #expected} an agent has, and where the second velocity begins. */
    static final int EXPECTED = 4;

    static final int COMING = 2;

    final int count;
    final int cols;
    final int rows;
    private final double edge;
    private final double perEdge;
    private final int[] starts;
    private final int[] cellOf;
    /** The agent at each place. */
    final int[] agent;

    final double[] x;
    final double[] y;
    final double[] z;
    final double[] headingX;
    final double[] headingY;
    final double[] speed;
    final double[] radius;
    final double[] topSpeed;
    final int[] leaf;
    final byte[] state;
    /** {@value #EXPECTED} numbers each: the velocity that others expect, then the one that who comes against it expects. */
    final double[] expected;

    /** The direction of each agent's path, a unit vector or 0. */
    final double[] pathX;

    final double[] pathY;
    final int[] span;
    final boolean[] roomy;
    final boolean[] tight;
    final int[] still;
    /** The goal of each agent, and its rank: the higher has the right of way. */
    final long[] rank;

    final int[] yielding;
    /** The potential of NF2 that is left, in metres. */
    final float[] left;

    /** Makes room for the agents of a world. */
    Cells(int count, double width, double depth, double view) {
        this.count = count;
        double side = view / REACH;
        while ((width / side + 1) * (depth / side + 1) > MOST_CELLS) {
            side *= 2;
        }
        edge = side;
        perEdge = 1 / side;
        cols = (int) (width / side) + 1;
        rows = (int) (depth / side) + 1;
        starts = new int[cols * rows + 1];
        cellOf = new int[count];
        agent = new int[count];
        x = new double[count];
        y = new double[count];
        z = new double[count];
        headingX = new double[count];
        headingY = new double[count];
        speed = new double[count];
        radius = new double[count];
        topSpeed = new double[count];
        leaf = new int[count];
        state = new byte[count];
        expected = new double[EXPECTED * count];
        span = new int[count];
        roomy = new boolean[count];
        tight = new boolean[count];
        still = new int[count];
        pathX = new double[count];
        pathY = new double[count];
        rank = new long[count];
        yielding = new int[count];
        left = new float[count];
    }

    /** Sorts the agents where they stand now. */
    void sort(Agents agents) {
        Arrays.fill(starts, 0);
        for (int i = 0; i < count; i++) {
            int cell = row(agents.y[i]) * cols + col(agents.x[i]);
            cellOf[i] = cell;
            starts[cell + 1]++;
        }
        for (int cell = 1; cell < starts.length; cell++) {
            starts[cell] += starts[cell - 1];
        }
        for (int i = 0; i < count; i++) {
            take(agents, i, starts[cellOf[i]]++);
        }
        System.arraycopy(starts, 0, starts, 1, starts.length - 1);
        starts[0] = 0;
    }

    private void take(Agents agents, int i, int place) {
        agent[place] = i;
        x[place] = agents.x[i];
        y[place] = agents.y[i];
        z[place] = agents.z[i];
        headingX[place] = agents.headingX[i];
        headingY[place] = agents.headingY[i];
        speed[place] = agents.speed[i];
        radius[place] = agents.radius[i];
        topSpeed[place] = agents.topSpeed[i];
        leaf[place] = agents.leaf[i];
        state[place] = agents.state[i];
        yielding[place] = agents.yielding[i];
        span[place] = agents.span[i];
        roomy[place] = agents.roomy[i];
        tight[place] = agents.tight[i];
        still[place] = agents.still[i];
        boolean goes = agents.state[i] != Agents.ARRIVED;
        pathX[place] = goes ? agents.pathX[i] : 0;
        pathY[place] = goes ? agents.pathY[i] : 0;
        int at = EXPECTED * place;
        expected[at] = headingX[place] * speed[place];
        expected[at + 1] = headingY[place] * speed[place];
        // who comes against one is expected to come on, even if it stands at the moment
        double pace = Math.max(speed[place], 0.5 * topSpeed[place]);
        expected[at + COMING] = pathX[place] * pace;
        expected[at + COMING + 1] = pathY[place] * pace;
        left[place] = agents.left[i];
        rank[place] = agents.rank[i];
    }

    int col(double atX) {
        return Math.max(0, Math.min(cols - 1, (int) (atX * perEdge)));
    }

    int row(double atY) {
        return Math.max(0, Math.min(rows - 1, (int) (atY * perEdge)));
    }

    /**
     * Returns at least how far to both sides in metres a disc reaches within a row of cells: with r its radius and d
     * the distance of the row, {@code sqrt(r^2 - d^2) <= r - d^2 / 2 r}.
     *
     * @param radius of the disc in metres
     * @param y of its centre in metres
     */
    double halfWidth(double radius, double y, int row) {
        double apart = Math.max(0, Math.max(row * edge - y, y - (row + 1) * edge) - 1e-9);
        return radius - apart * apart / (2 * radius);
    }

    /** Returns the first place of a run of cells. */
    int start(int col, int row) {
        return starts[row * cols + col];
    }

    /** Returns the place after the last of a run of cells that ends with {@code col}. */
    int end(int col, int row) {
        return starts[row * cols + col + 1];
    }
}
