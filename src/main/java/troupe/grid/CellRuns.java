package troupe.grid;

import java.util.Arrays;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.scene.World;

/**
 * Collects sets of cells as runs: cell indices {@code [from, to)} within one row. Runs may overlap; they
 * come polygon by polygon and within each in no particular order. Distances are compared in double precision
 * at the cell centres; rows and columns outside the frame are left out. The buffer grows as needed and
 * is meant to be used again after {@link #clear}.
 */
public final class CellRuns {
    /** Slack in cells within which a coordinate lies on a cell border. */
    private static final double ON_BORDER = 1e-9;

    private final GridFrame frame;
    private int[] runs = new int[256];
    private int length;
    private double[] crossings = new double[16];

    /** Makes an empty list of runs of a grid. */
    public CellRuns(GridFrame frame) {
        this.frame = frame;
    }

    /** Drops all runs. */
    public void clear() {
        length = 0;
    }

    /** Returns the number of runs. */
    public int size() {
        return length / 2;
    }

    /** Returns the index of the first cell of a run. */
    public int from(int run) {
        return runs[2 * run];
    }

    /** Returns the index behind the last cell of a run. */
    public int to(int run) {
        return runs[2 * run + 1];
    }

    private void add(int row, int fromCol, int toCol) {
        int from = Math.max(0, fromCol);
        int to = Math.min(frame.cols(), toCol);
        if (from >= to) {
            return;
        }
        if (length == runs.length) {
            runs = Arrays.copyOf(runs, 2 * length);
        }
        runs[length++] = row * frame.cols() + from;
        runs[length++] = row * frame.cols() + to;
    }

    /** Returns the runs collected, {@code from} and {@code to} in turn; a new array. */
    public int[] copy() {
        return Arrays.copyOf(runs, length);
    }

    /** Adds runs that {@link #copy} returned for the same frame. */
    public void add(int[] copied) {
        if (length + copied.length > runs.length) {
            runs = Arrays.copyOf(runs, 2 * (length + copied.length));
        }
        System.arraycopy(copied, 0, runs, length, copied.length);
        length += copied.length;
    }

    /** Adds the cells whose centre lies in the world's rectangle. */
    public void inside(World world) {
        int rows = firstRow(world.depth());
        for (int row = Math.max(0, firstRow(0)); row < rows; row++) {
            add(row, firstCol(0), firstCol(world.width()));
        }
    }

    /** Adds the cells whose centre lies in the world's rectangle but nearer than {@code radius} to its edge. */
    public void nearEdge(World world, double radius) {
        int bottom = Math.max(0, firstRow(0));
        int left = firstCol(0);
        int right = firstCol(world.width());
        int top = Math.min(frame.rows(), firstRow(world.depth()));
        int innerLeft = Math.max(left, firstCol(radius));
        int innerRight = Math.max(innerLeft, Math.min(right, firstCol(world.width() - radius)));
        for (int row = bottom; row < top; row++) {
            double y = frame.centreY(row);
            if (y < radius || world.depth() - y < radius) {
                add(row, left, right);
            } else {
                add(row, left, innerLeft);
                add(row, innerRight, right);
            }
        }
    }

    /** Adds the cells whose centre is inside the polygon: even-odd, half-open edges, as {@link Polygon#contains}. */
    public void fill(Polygon polygon) {
        Box box = polygon.bounds();
        if (crossings.length < polygon.size()) {
            crossings = new double[2 * polygon.size()];
        }
        int last = Math.min(frame.rows(), firstRow(box.maxY()) + 1);
        for (int row = Math.max(0, firstRow(box.minY())); row < last; row++) {
            int count = crossings(polygon, frame.centreY(row));
            Arrays.sort(crossings, 0, count);
            for (int i = 0; i + 1 < count; i += 2) {
                add(row, firstCol(crossings[i]), firstCol(crossings[i + 1]));
            }
        }
    }

    private int crossings(Polygon polygon, double y) {
        int count = 0;
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            if ((polygon.y(i) <= y) != (polygon.y(j) <= y)) {
                int low = polygon.y(i) <= polygon.y(j) ? i : j;
                int high = low == i ? j : i;
                crossings[count++] = polygon.x(low)
                        + (y - polygon.y(low))
                                * (polygon.x(high) - polygon.x(low))
                                / (polygon.y(high) - polygon.y(low));
            }
        }
        return count;
    }

    /** Returns the first column whose centre is not left of {@code x}; it may lie outside the frame. */
    private int firstCol(double x) {
        int col = (int) Math.ceil((x - frame.originX()) / frame.cell() - 0.5);
        while (frame.centreX(col - 1) >= x) {
            col--;
        }
        while (frame.centreX(col) < x) {
            col++;
        }
        return col;
    }

    /** Returns the first row whose centre is not below {@code y}; it may lie outside the frame. */
    private int firstRow(double y) {
        int row = (int) Math.ceil((y - frame.originY()) / frame.cell() - 0.5);
        while (frame.centreY(row - 1) >= y) {
            row--;
        }
        while (frame.centreY(row) < y) {
            row++;
        }
        return row;
    }

    /** Adds the cells whose centre is nearer than {@code radius} metres to the outline, inside or out. */
    public void near(Polygon polygon, double radius) {
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            near(polygon.x(j), polygon.y(j), polygon.x(i), polygon.y(i), radius);
        }
    }

    /** Adds the cells whose centre is nearer than {@code radius} metres to the segment {@code a-b}. */
    public void near(double ax, double ay, double bx, double by, double radius) {
        double dx = bx - ax;
        double dy = by - ay;
        double length = Math.sqrt(dx * dx + dy * dy);
        double nx = length == 0 ? 0 : -dy / length * radius;
        double ny = length == 0 ? 0 : dx / length * radius;
        double square = radius * radius;
        int last = Math.min(frame.rows(), firstRow(Math.max(ay, by) + radius) + 1);
        for (int row = Math.max(0, firstRow(Math.min(ay, by) - radius)); row < last; row++) {
            double y = frame.centreY(row);
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            double halfA = square - (y - ay) * (y - ay);
            if (halfA >= 0) {
                double half = Math.sqrt(halfA);
                low = ax - half;
                high = ax + half;
            }
            double halfB = square - (y - by) * (y - by);
            if (halfB >= 0) {
                double half = Math.sqrt(halfB);
                low = Math.min(low, bx - half);
                high = Math.max(high, bx + half);
            }
            if (dy != 0) {
                double t = (y - ay - ny) / dy;
                double u = (y - ay + ny) / dy;
                if (t >= 0 && t <= 1) {
                    low = Math.min(low, ax + nx + t * dx);
                    high = Math.max(high, ax + nx + t * dx);
                }
                if (u >= 0 && u <= 1) {
                    low = Math.min(low, ax - nx + u * dx);
                    high = Math.max(high, ax - nx + u * dx);
                }
            }
            if (low <= high) {
                addExact(row, low, high, ax, ay, bx, by, square);
            }
        }
    }

    /** Adds the run between two x after moving its ends to where the distance itself says. */
    private void addExact(int row, double low, double high, double ax, double ay, double bx, double by, double square) {
        double y = frame.centreY(row);
        int first = Math.max(0, (int) ((low - frame.originX()) / frame.cell() - 0.5));
        int last = Math.min(frame.cols() - 1, (int) ((high - frame.originX()) / frame.cell() + 0.5));
        while (first <= last && !(squared(first, y, ax, ay, bx, by) < square)) {
            first++;
        }
        while (first <= last && !(squared(last, y, ax, ay, bx, by) < square)) {
            last--;
        }
        add(row, first, last + 1);
    }

    private double squared(int col, double y, double ax, double ay, double bx, double by) {
        return Segments.distanceSquared(frame.centreX(col), y, ax, ay, bx, by);
    }

    /** Adds the cells whose open inside the outline crosses; an edge along cell borders touches none. */
    public void touch(Polygon polygon) {
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            touch(polygon.x(j), polygon.y(j), polygon.x(i), polygon.y(i));
        }
    }

    /** Adds the cells whose open inside the segment {@code a-b} crosses, to a slack of 1e-9 cells. */
    public void touch(double ax, double ay, double bx, double by) {
        boolean up = ay <= by;
        double u0 = ((up ? ax : bx) - frame.originX()) / frame.cell();
        double v0 = ((up ? ay : by) - frame.originY()) / frame.cell();
        double u1 = ((up ? bx : ax) - frame.originX()) / frame.cell();
        double v1 = ((up ? by : ay) - frame.originY()) / frame.cell();
        int last = Math.min(frame.rows() - 1, (int) Math.ceil(v1 - ON_BORDER) - 1);
        for (int row = Math.max(0, (int) Math.floor(v0 + ON_BORDER)); row <= last; row++) {
            double t0 = v0 < row ? (row - v0) / (v1 - v0) : 0;
            double t1 = v1 > row + 1 ? (row + 1 - v0) / (v1 - v0) : 1;
            double ua = u0 + t0 * (u1 - u0);
            double ub = u0 + t1 * (u1 - u0);
            add(row, (int) Math.floor(Math.min(ua, ub) + ON_BORDER), (int) Math.ceil(Math.max(ua, ub) - ON_BORDER));
        }
    }
}
