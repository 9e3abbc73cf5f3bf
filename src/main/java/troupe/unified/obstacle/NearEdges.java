package troupe.unified.obstacle;

import java.util.Arrays;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.scene.World;

/**
 * Finds the edges of outlines near a point. The world is divided into squares; each keeps the edges whose
 * box comes within a reach of it, found when the square is first asked for. The reach is given once, so
 * that far outlines cost nothing. Used by one thread at a time.
 */
final class NearEdges {
    private static final int MOST_SQUARES = 128;
    private static final int[] NONE = {};

    private final double reach;
    private final double side;
    private final int cols;
    private final int rows;
    private final int[][] squares;
    private final double[] ax;
    private final double[] ay;
    private final double[] bx;
    private final double[] by;
    private final int[] owners;
    private final Polygon[] outlines;
    private int[] found = new int[32];

    /**
     * Takes in the outlines; edges of no length are left out.
     *
     * @param reach how far around a point edges are found at least, in metres, above 0
     */
    NearEdges(World world, List<Polygon> outlines, double reach) {
        this.reach = reach;
        this.outlines = outlines.toArray(new Polygon[0]);
        side = Math.max(reach / 2, Math.max(world.width(), world.depth()) / MOST_SQUARES);
        cols = (int) Math.ceil(world.width() / side) + 1;
        rows = (int) Math.ceil(world.depth() / side) + 1;
        squares = new int[cols * rows][];
        int most = outlines.stream().mapToInt(Polygon::size).sum();
        ax = new double[most];
        ay = new double[most];
        bx = new double[most];
        by = new double[most];
        owners = new int[most];
        int count = 0;
        for (int o = 0; o < this.outlines.length; o++) {
            Polygon p = this.outlines[o];
            for (int i = 0, j = p.size() - 1; i < p.size(); j = i++) {
                if (p.x(i) != p.x(j) || p.y(i) != p.y(j)) {
                    ax[count] = p.x(j);
                    ay[count] = p.y(j);
                    bx[count] = p.x(i);
                    by[count] = p.y(i);
                    owners[count++] = o;
                }
            }
        }
        Arrays.fill(owners, count, most, -1);
    }

    /** Returns the edges near a point of the world, in the order in which they were taken in; not to be changed. */
    int[] near(double x, double y) {
        int col = Math.max(0, Math.min(cols - 1, (int) (x / side)));
        int row = Math.max(0, Math.min(rows - 1, (int) (y / side)));
        int[] known = squares[row * cols + col];
        if (known == null) {
            known = find(col * side - reach, row * side - reach, (col + 1) * side + reach, (row + 1) * side + reach);
            squares[row * cols + col] = known;
        }
        return known;
    }

    private int[] find(double minX, double minY, double maxX, double maxY) {
        int count = 0;
        for (int e = 0; e < owners.length && owners[e] >= 0; e++) {
            if (meetsBox(e, minX, minY, maxX, maxY)) {
                if (count == found.length) {
                    found = Arrays.copyOf(found, 2 * count);
                }
                found[count++] = e;
            }
        }
        return count == 0 ? NONE : Arrays.copyOf(found, count);
    }

    /** Tells whether the box of an edge meets a box. */
    boolean meetsBox(int edge, double minX, double minY, double maxX, double maxY) {
        return Math.min(ax[edge], bx[edge]) <= maxX
                && Math.max(ax[edge], bx[edge]) >= minX
                && Math.min(ay[edge], by[edge]) <= maxY
                && Math.max(ay[edge], by[edge]) >= minY;
    }

    double ax(int edge) {
        return ax[edge];
    }

    double ay(int edge) {
        return ay[edge];
    }

    double bx(int edge) {
        return bx[edge];
    }

    double by(int edge) {
        return by[edge];
    }

    /** Returns the number of the outline that an edge belongs to. */
    int owner(int edge) {
        return owners[edge];
    }

    /** Returns an outline by its number. */
    Polygon outline(int owner) {
        return outlines[owner];
    }
}
