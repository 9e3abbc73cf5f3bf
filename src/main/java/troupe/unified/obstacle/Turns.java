package troupe.unified.obstacle;

import troupe.geometry.Point;
import troupe.grid.GridFrame;

/**
 * Knows the cells that an actor passes who holds an obstacle that turns: where it is at each heading, and
 * the steps between. Places within 1e-9 of a cell below the next cell count as that one, so that rounding
 * does not decide where symmetry leads onto a border. Relative to the obstacle's lattice position: at the
 * pose (i, j, k) all cells are shifted by (i, j). Immutable.
 */
final class Turns {
    private static final double SLACK = 1e-9;

    private final GridFrame frame;
    private final Movable movable;
    private final double armX;
    private final double armY;
    private final int parts;
    private final double[] cosines;
    private final double[] sines;
    private final double[] xs;
    private final double[] ys;
    private final int[] cols;
    private final int[] rows;
    private final byte[][] steps;
    private final int[] straight;
    private final int[] diagonal;

    /** Finds the cells of an actor that stands at {@code (x, y)} while the obstacle has its own pose. */
    Turns(GridFrame frame, Movable movable, double x, double y) {
        this.frame = frame;
        this.movable = movable;
        this.armX = x - movable.centroid().x();
        this.armY = y - movable.centroid().y();
        int headings = movable.headings();
        double length = lever() * movable.turn() / (movable.cell() / 2);
        this.parts = (int) Math.max(1, Math.ceil(length));
        this.cosines = new double[parts];
        this.sines = new double[parts];
        for (int part = 0; part < parts; part++) {
            cosines[part] = StrictMath.cos(part * movable.turn() / parts);
            sines[part] = StrictMath.sin(part * movable.turn() / parts);
        }
        this.xs = new double[headings];
        this.ys = new double[headings];
        this.cols = new int[headings];
        this.rows = new int[headings];
        this.steps = new byte[headings][];
        this.straight = new int[headings];
        this.diagonal = new int[headings];
        for (int k = 0; k < headings; k++) {
            Point at = at(k, 0);
            xs[k] = at.x();
            ys[k] = at.y();
            cols[k] = col(at);
            rows[k] = row(at);
        }
        for (int k = 0; k < headings; k++) {
            steps[k] = headings == 1 ? new byte[0] : walk(k);
            for (byte direction : steps[k]) {
                straight[k] += direction >= 0 && direction < 4 ? 1 : 0;
                diagonal[k] += direction >= 4 ? 1 : 0;
            }
        }
    }

    private byte[] walk(int k) {
        byte[] found = new byte[parts];
        int col = cols[k];
        int row = rows[k];
        int next = (k + 1) % cols.length;
        for (int part = 1; part <= parts; part++) {
            Point at = at(part == parts ? next : k, part == parts ? 0 : part);
            int toCol = col(at);
            int toRow = row(at);
            found[part - 1] = direction(toCol - col, toRow - row);
            col = toCol;
            row = toRow;
        }
        return found;
    }

    /** Returns the direction of {@link GridFrame} of a step between neighbours, -1 for staying, -2 for neither. */
    private static byte direction(int dx, int dy) {
        if (dx == 0 && dy == 0) {
            return -1;
        }
        for (byte d = 0; d < GridFrame.DIRECTIONS; d++) {
            if (GridFrame.dx(d) == dx && GridFrame.dy(d) == dy) {
                return d;
            }
        }
        return -2;
    }

    /** Returns the x in metres of the actor at heading {@code k}. */
    double x(int k) {
        return xs[k];
    }

    /** Returns the y in metres of the actor at heading {@code k}. */
    double y(int k) {
        return ys[k];
    }

    /** Returns where the actor is after {@code part} of the {@link #parts} of the turn from heading {@code k}. */
    private Point at(int k, int part) {
        if (k == 0 && part == 0) {
            return new Point(movable.centroid().x() + armX, movable.centroid().y() + armY);
        }
        double turnedX = movable.cos(k) * armX - movable.sin(k) * armY;
        double turnedY = movable.sin(k) * armX + movable.cos(k) * armY;
        return new Point(
                movable.centroid().x() + cosines[part] * turnedX - sines[part] * turnedY,
                movable.centroid().y() + sines[part] * turnedX + cosines[part] * turnedY);
    }

    private int col(Point at) {
        return (int) Math.floor((at.x() - frame.originX()) / frame.cell() + SLACK);
    }

    private int row(Point at) {
        return (int) Math.floor((at.y() - frame.originY()) / frame.cell() + SLACK);
    }

    /** Returns the distance in metres between the actor and the centroid. */
    double lever() {
        return Math.sqrt(armX * armX + armY * armY);
    }

    /** Returns in how many equal parts a turn by one heading is looked at. */
    int parts() {
        return parts;
    }

    /** Returns the column of the actor's cell at heading {@code k}. */
    int col(int k) {
        return cols[k];
    }

    /** Returns the row of the actor's cell at heading {@code k}. */
    int row(int k) {
        return rows[k];
    }

    /**
     * Returns the step in each part of the turn from heading {@code k} to the next: a direction of {@link
     * GridFrame}, -1 for staying in the cell, -2 for leaping over one. The array itself.
     */
    byte[] steps(int k) {
        return steps[k];
    }

    /** Returns the number of straight steps in the turn from heading {@code k} to the next. */
    int straight(int k) {
        return straight[k];
    }

    /** Returns the number of diagonal steps in the turn from heading {@code k} to the next. */
    int diagonal(int k) {
        return diagonal[k];
    }
}
