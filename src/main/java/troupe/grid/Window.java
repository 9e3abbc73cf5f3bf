package troupe.grid;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Box;

/** Holds a rectangle of cells of a frame, with its own row-major index {@code (row - row0) * cols + col - col0}. */
public record Window(int col0, int row0, int cols, int rows) {

    /** Makes the window of the cells that a box in metres meets, one more on each side, cut to the frame. */
    public static Window of(GridFrame frame, Box box) {
        int left = Math.max(0, frame.colAt(box.minX()) - 1);
        int low = Math.max(0, frame.rowAt(box.minY()) - 1);
        int right = Math.min(frame.cols() - 1, frame.colAt(box.maxX()) + 1);
        int high = Math.min(frame.rows() - 1, frame.rowAt(box.maxY()) + 1);
        return new Window(left, low, Math.max(0, right - left + 1), Math.max(0, high - low + 1));
    }

    /** Returns the number of cells. */
    public int size() {
        return cols * rows;
    }

    /** Returns this window grown by {@code margin} cells on each side, cut to the frame. */
    public Window grown(int margin, GridFrame frame) {
        int left = Math.max(0, col0 - margin);
        int low = Math.max(0, row0 - margin);
        int right = Math.min(frame.cols(), col0 + cols + margin);
        int high = Math.min(frame.rows(), row0 + rows + margin);
        return new Window(left, low, right - left, high - low);
    }

    /** Tells whether the two share a cell. */
    public boolean meets(Window other) {
        return col0 < other.col0 + other.cols
                && other.col0 < col0 + cols
                && row0 < other.row0 + other.rows
                && other.row0 < row0 + rows;
    }

    /** Returns the cells that both hold, maybe none. */
    public Window common(Window other) {
        int left = Math.max(col0, other.col0);
        int low = Math.max(row0, other.row0);
        int right = Math.min(col0 + cols, other.col0 + other.cols);
        int high = Math.min(row0 + rows, other.row0 + other.rows);
        return new Window(left, low, Math.max(0, right - left), Math.max(0, high - low));
    }

    /** Returns the index here of a cell of the frame that lies in this window. */
    public int index(GridFrame frame, int at) {
        int row = at / frame.cols();
        return (row - row0) * cols + at - row * frame.cols() - col0;
    }

    /** Returns the smallest window that holds the cells set in a mask of this one, none if all are clear. */
    public Window occupied(byte[] mask) {
        int left = cols;
        int right = -1;
        int low = rows;
        int high = -1;
        for (int row = 0; row < rows; row++) {
            int base = row * cols;
            int first = 0;
            while (first < cols && mask[base + first] == 0) {
                first++;
            }
            if (first == cols) {
                continue;
            }
            int last = cols - 1;
            while (mask[base + last] == 0) {
                last--;
            }
            left = Math.min(left, first);
            right = Math.max(right, last);
            low = Math.min(low, row);
            high = row;
        }
        return high < 0
                ? new Window(0, 0, 0, 0)
                : new Window(col0 + left, row0 + low, right - left + 1, high - low + 1);
    }

    /** Returns the part of a mask of this window that belongs to a window within it; a new array. */
    public byte[] cut(byte[] mask, Window part) {
        byte[] cut = new byte[part.size()];
        for (int row = 0; row < part.rows; row++) {
            int from = (part.row0 + row - row0) * cols + part.col0 - col0;
            System.arraycopy(mask, from, cut, row * part.cols, part.cols);
        }
        return cut;
    }

    /** Returns a mask of a window {@code whole}, clear but for its {@code part}, which lies in this one, too. */
    public byte[] cut(byte[] mask, Window part, Window whole) {
        byte[] cut = new byte[whole.size()];
        for (int row = part.row0; row < part.row0 + part.rows; row++) {
            int from = (row - row0) * cols + part.col0 - col0;
            int to = (row - whole.row0) * whole.cols + part.col0 - whole.col0;
            System.arraycopy(mask, from, cut, to, part.cols);
        }
        return cut;
    }

    private Window union(Window other) {
        int left = Math.min(col0, other.col0);
        int low = Math.min(row0, other.row0);
        int right = Math.max(col0 + cols, other.col0 + other.cols);
        int high = Math.max(row0 + rows, other.row0 + other.rows);
        return new Window(left, low, right - left, high - low);
    }

    /**
     * Returns windows that cover the given ones, two becoming one where that has fewer cells once each is
     * grown by {@code margin}. Cost O(n³) at worst, n windows.
     */
    public static List<Window> merged(List<Window> windows, int margin) {
        List<Window> merged = new ArrayList<>();
        for (Window window : windows) {
            Window grown = window;
            for (int i = 0; i < merged.size(); i++) {
                Window both = grown.union(merged.get(i));
                if (both.area(margin) <= grown.area(margin) + merged.get(i).area(margin)) {
                    merged.remove(i);
                    grown = both;
                    i = -1;
                }
            }
            merged.add(grown);
        }
        return merged;
    }

    private long area(int margin) {
        return (long) (cols + 2 * margin) * (rows + 2 * margin);
    }

    /** Tells whether a cell lies in it. */
    public boolean holds(int col, int row) {
        return col >= col0 && col < col0 + cols && row >= row0 && row < row0 + rows;
    }

    /** Receives the stretches of runs that lie in a window. */
    public interface Stretch {
        /** Takes the window indices {@code [from, to)}. */
        void take(int from, int to);
    }

    /** Hands on the parts of the runs that lie in this window. */
    public void each(CellRuns runs, GridFrame frame, Stretch stretch) {
        for (int i = 0; i < runs.size(); i++) {
            int row = runs.from(i) / frame.cols();
            if (row < row0 || row >= row0 + rows) {
                continue;
            }
            int base = row * frame.cols();
            int from = Math.max(runs.from(i) - base, col0);
            int to = Math.min(runs.to(i) - base, col0 + cols);
            int own = (row - row0) * cols - col0;
            if (from < to) {
                stretch.take(own + from, own + to);
            }
        }
    }

    /** Returns boxes that cover the given ones and do not meet each other. Cost O(n³) at worst, n boxes. */
    public static List<Box> apart(List<Box> boxes) {
        List<Box> apart = new ArrayList<>();
        for (Box box : boxes) {
            Box grown = box;
            for (int i = 0; i < apart.size(); i++) {
                if (apart.get(i).meets(grown)) {
                    grown = grown.union(apart.remove(i));
                    i = -1;
                }
            }
            apart.add(grown);
        }
        return apart;
    }
}
