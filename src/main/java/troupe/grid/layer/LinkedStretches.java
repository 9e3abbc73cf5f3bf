package troupe.grid.layer;

import java.util.Arrays;

/**
 * Finds which spans hang together by links. Each row is cut into segments of one column; the spans of a
 * segment on one sheet are a stretch, {@code segment * sheets + sheet}, and stretches that a link joins
 * are united, always under the older one. So links are asked once for two segments that meet, not once for
 * two cells.
 */
final class LinkedStretches {
    private final Spans spans;
    private final double stepHeight;
    private final double bodyHeight;
    private final int sheets;
    private final int cols;
    private final int[] at;
    private int[] starts = new int[256];
    private int segments;
    private final int[] parent;

    public LinkedStretches(Spans spans, double stepHeight, double bodyHeight) {
        this.spans = spans;
        this.stepHeight = stepHeight;
        this.bodyHeight = bodyHeight;
        this.sheets = spans.sheets();
        this.cols = spans.frame().cols();
        this.at = spans.columnAt();
        int rows = spans.frame().rows();
        int[] firstOfRow = new int[rows + 1];
        for (int row = 0; row < rows; row++) {
            firstOfRow[row] = segments;
            cut(row * cols);
        }
        firstOfRow[rows] = segments;
        starts = Arrays.copyOf(starts, segments + 1);
        starts[segments] = at.length;
        this.parent = new int[segments * sheets];
        Arrays.setAll(parent, i -> i);
        for (int row = 0; row < rows; row++) {
            for (int s = firstOfRow[row]; s + 1 < firstOfRow[row + 1]; s++) {
                join(s, s + 1);
            }
            if (row > 0) {
                joinRows(firstOfRow[row - 1], firstOfRow[row], firstOfRow[row + 1]);
            }
        }
    }

    private void cut(int rowStart) {
        int before = -1;
        for (int cell = rowStart, end = rowStart + cols; cell < end; cell++) {
            if (at[cell] != before) {
                before = at[cell];
                if (segments == starts.length) {
                    starts = Arrays.copyOf(starts, 2 * segments);
                }
                starts[segments++] = cell;
            }
        }
    }

    /** Joins the segments of one row, {@code [middle, end)}, to those of the row below, {@code [first, middle)}. */
    private void joinRows(int first, int middle, int end) {
        int low = first;
        for (int high = middle; high < end; ) {
            join(low, high);
            int lowEnd = starts[low + 1] + cols;
            int highEnd = starts[high + 1];
            if (lowEnd <= highEnd) {
                low++;
            }
            if (highEnd <= lowEnd) {
                high++;
            }
        }
    }

    private void join(int a, int b) {
        int columnA = column(a);
        int columnB = column(b);
        for (int sheet = 0; sheet < sheets; sheet++) {
            if (spans.level(columnA, sheet) < 0) {
                continue;
            }
            int target = columnA == columnB ? sheet : spans.linked(columnA, sheet, columnB, stepHeight, bodyHeight);
            if (target >= 0) {
                int rootA = root(a * sheets + sheet);
                int rootB = root(b * sheets + target);
                parent[Math.max(rootA, rootB)] = Math.min(rootA, rootB);
            }
        }
    }

    /** Returns the number of segments. */
    public int segments() {
        return segments;
    }

    /** Returns the first cell of a segment; the one after it begins where it ends. */
    public int start(int segment) {
        return starts[segment];
    }

    /** Returns the column of a segment. */
    public int column(int segment) {
        return at[starts[segment]];
    }

    /** Returns the oldest stretch of the piece that a stretch belongs to. */
    public int root(int stretch) {
        int root = stretch;
        while (parent[root] != root) {
            parent[root] = parent[parent[root]];
            root = parent[root];
        }
        return root;
    }

    /** Returns, per stretch that is a root, whether its piece lies over some cell twice. */
    public boolean[] overlapping() {
        boolean[] overlapping = new boolean[parent.length];
        for (int segment = 0; segment < segments; segment++) {
            for (int high = 1; high < sheets && spans.level(column(segment), high) >= 0; high++) {
                for (int low = 0; low < high; low++) {
                    int root = root(segment * sheets + high);
                    overlapping[root] |= root == root(segment * sheets + low);
                }
            }
        }
        return overlapping;
    }
}
