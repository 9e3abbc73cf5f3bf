package troupe.grid;

import troupe.scene.World;

/**
 * Converts between metres and cells. Cells are half-open squares of edge {@code cell} metres, numbered
 * row-major from the bottom left, {@code i = row * cols + col}, y up; the centre of column 0 lies at
 * {@code originX + cell / 2}. It is the only place where metres and cells meet.
 *
 * <p>The frame of a world carries a border of one cell on every side, which is always solid, so that
 * kernels need no bounds checks.
 */
public record GridFrame(double originX, double originY, double cell, int cols, int rows) {
    /** Column and row steps of the eight directions: E, N, W, S, then NE, NW, SW, SE. */
    private static final int[] DX = {1, 0, -1, 0, 1, -1, -1, 1};

    private static final int[] DY = {0, 1, 0, -1, 1, 1, -1, -1};

    /** The number of directions; the first four are straight, the others diagonal. */
    public static final int DIRECTIONS = 8;

    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if the cell is not positive and finite, or a count is below 1
     */
    public GridFrame {
        if (!(cell > 0) || Double.isInfinite(cell) || cols < 1 || rows < 1) {
            throw new IllegalArgumentException("grid of " + cols + " x " + rows + " cells of " + cell
                    + " m; needs at least 1 x 1 of a size above 0");
        }
    }

    /** Makes the frame of a world: its cells and a solid border of one cell around them. */
    public static GridFrame of(World world) {
        return new GridFrame(-world.cell(), -world.cell(), world.cell(), world.cols() + 2, world.rows() + 2);
    }

    /** Returns the number of cells, border included. */
    public int size() {
        return cols * rows;
    }

    /** Returns the cell index of a column and a row. */
    public int index(int col, int row) {
        return row * cols + col;
    }

    /** Returns the column of a cell index. */
    public int col(int index) {
        return index % cols;
    }

    /** Returns the row of a cell index. */
    public int row(int index) {
        return index / cols;
    }

    /** Returns the x in metres of the centre of a column. */
    public double centreX(int col) {
        return originX + (col + 0.5) * cell;
    }

    /** Returns the y in metres of the centre of a row. */
    public double centreY(int row) {
        return originY + (row + 0.5) * cell;
    }

    /** Returns the column that holds {@code x} metres; it may lie outside {@code [0, cols)}. */
    public int colAt(double x) {
        return (int) Math.floor((x - originX) / cell);
    }

    /** Returns the row that holds {@code y} metres; it may lie outside {@code [0, rows)}. */
    public int rowAt(double y) {
        return (int) Math.floor((y - originY) / cell);
    }

    /** Returns the cell that holds a place in metres, or -1 outside the frame. */
    public int cellAt(double x, double y) {
        int col = colAt(x);
        int row = rowAt(y);
        return col < 0 || row < 0 || col >= cols || row >= rows ? -1 : index(col, row);
    }

    /** Returns the column step of direction {@code d}, {@code 0 <= d < 8}. */
    public static int dx(int d) {
        return DX[d];
    }

    /** Returns the row step of direction {@code d}, {@code 0 <= d < 8}. */
    public static int dy(int d) {
        return DY[d];
    }

    /** Returns the index step of each direction in this frame; a new array of 8. */
    public int[] offsets() {
        int[] offsets = new int[DIRECTIONS];
        for (int d = 0; d < DIRECTIONS; d++) {
            offsets[d] = DY[d] * cols + DX[d];
        }
        return offsets;
    }

    /** Returns the length in metres of a step in direction {@code d}: a cell, or its diagonal. */
    public double stepLength(int d) {
        return d < 4 ? cell : cell * Math.sqrt(2);
    }
}
