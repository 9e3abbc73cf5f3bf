package troupe.unified.obstacle;

import java.util.Arrays;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.grid.CellRuns;
import troupe.grid.GridFrame;

/**
 * Holds the cells whose centre is nearer to a polygon than a radius, in columns and rows of the world's
 * frame continued in all directions: bits for single questions, and disjoint runs for copying. Immutable.
 */
public final class Stamp {
    /** How far in metres a distance falls short of the radius before it counts. */
    static final double SLACK = 1e-9;

    private final double radius;
    private final int firstCol;
    private final int firstRow;
    private final int cols;
    private final int rows;
    private final int words;
    private final long[] bits;
    private final int[] runs;

    private Stamp(double radius, GridFrame frame, int firstCol, int firstRow, CellRuns cells) {
        this.radius = radius;
        this.firstCol = firstCol;
        this.firstRow = firstRow;
        this.cols = frame.cols();
        this.rows = frame.rows();
        this.words = (cols + Long.SIZE - 1) / Long.SIZE;
        this.bits = new long[words * rows];
        for (int run = 0; run < cells.size(); run++) {
            int row = frame.row(cells.from(run));
            Bits.set(bits, row * words, frame.col(cells.from(run)), cells.to(run) - row * cols);
        }
        this.runs = collect();
    }

    /** Finds the cells nearer than {@code radius}, by more than {@link #SLACK}, to a filled polygon. */
    static Stamp of(Polygon outline, double radius, double cell) {
        double reach = radius - SLACK;
        Box box = outline.bounds().grown(Math.max(reach, 0));
        int firstCol = (int) Math.floor(box.minX() / cell);
        int firstRow = (int) Math.floor(box.minY() / cell);
        GridFrame frame = new GridFrame(
                (firstCol - 1) * cell,
                (firstRow - 1) * cell,
                cell,
                (int) Math.ceil(box.maxX() / cell) - firstCol + 2,
                (int) Math.ceil(box.maxY() / cell) - firstRow + 2);
        CellRuns cells = new CellRuns(frame);
        if (reach > 0) {
            cells.fill(outline);
            cells.near(outline, reach);
        }
        return new Stamp(radius, frame, firstCol, firstRow, cells);
    }

    private int[] collect() {
        int[] found = new int[16];
        int count = 0;
        for (int row = 0; row < rows; row++) {
            int base = row * words;
            int from = Bits.next(bits, base, 0, cols);
            while (from < cols) {
                int to = Bits.nextClear(bits, base, from, cols);
                if (count + 3 > found.length) {
                    found = Arrays.copyOf(found, 2 * found.length);
                }
                found[count++] = row + firstRow;
                found[count++] = from + firstCol;
                found[count++] = to + firstCol;
                from = Bits.next(bits, base, to, cols);
            }
        }
        return Arrays.copyOf(found, count);
    }

    /** Returns the radius in metres that it was made for. */
    double radius() {
        return radius;
    }

    /** Returns the runs by row: row, first column, and the column after the last; the array itself. */
    public int[] runs() {
        return runs;
    }

    /** Tells whether a cell is one of them; any column and row may be asked for. */
    boolean contains(int col, int row) {
        int c = col - firstCol;
        int r = row - firstRow;
        return c >= 0 && r >= 0 && c < cols && r < rows && Bits.get(bits, r * words, c);
    }
}
