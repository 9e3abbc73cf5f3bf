package troupe.grid.layer;

import java.util.Arrays;
import java.util.Locale;
import troupe.grid.GridFrame;
import troupe.grid.GridLimitException;
import troupe.scene.GridMemory;

/**
 * Holds the spans of a scene: the free stretches {@code (floor, ceiling)} over each cell in which the
 * smallest body in use can stand. The k-th span of a cell from below lies on sheet k; the id of a span is
 * {@code sheet * frame().size() + cell}. Immutable.
 *
 * <p>Kept is a stretch at least as tall as the body (to 1e-9 m). Floors are ground and tops of immovable
 * obstacles; a movable obstacle neither carries nor ends a span. A cell stores the number of its column only, so that a scene without
 * overhang costs four bytes per cell. Source: Unified section 3; Li and Huang's layered scenes.
 */
public final class Spans {
    /** The most floors above each other; a taller stack than any building has. */
    static final int MOST_SHEETS = 200;

    private static final int BYTES_PER_ENTRY = 20;

    private final GridFrame frame;
    private final int size;
    private final int sheets;
    private final int[] at;
    private final int columns;
    private final double[] floors;
    private final double[] ceilings;
    private final int[] levels;
    private final double[] elevations;

    /**
     * Finds the spans of {@code bodyHeight} metres in each distinct column.
     *
     * @throws GridLimitException if there are more than {@value #MOST_SHEETS} above each other, or so many
     *     that planning would not fit into memory
     */
    public Spans(GridFrame frame, Columns columns, double bodyHeight) {
        this.frame = frame;
        this.size = frame.size();
        this.at = columns.at();
        this.columns = columns.count();
        int most = 1;
        for (int id = 0; id < this.columns; id++) {
            most = Math.max(most, kept(columns.column(id), bodyHeight, null, null, 0));
        }
        this.sheets = checked(most);
        this.floors = new double[this.columns * most];
        this.ceilings = new double[this.columns * most];
        Arrays.fill(floors, Double.NaN);
        Arrays.fill(ceilings, Double.NaN);
        for (int id = 0; id < this.columns; id++) {
            kept(columns.column(id), bodyHeight, floors, ceilings, id * most);
        }
        this.elevations = distinct(floors);
        this.levels = new int[floors.length];
        for (int i = 0; i < floors.length; i++) {
            levels[i] = Double.isNaN(floors[i]) ? -1 : nearest(elevations, floors[i]);
        }
    }

    /** Returns the number of sheets after checking that the spans, and the table over the columns, fit. */
    private int checked(int most) {
        double bytes = (double) most * size * GridMemory.BYTES_PER_CELL + (double) most * columns * BYTES_PER_ENTRY;
        if (most > MOST_SHEETS || (double) most * size > GridMemory.mostCells() || bytes > GridMemory.bytes()) {
            throw new GridLimitException(
                    String.format(
                            Locale.ROOT,
                            "%d floors above each other over %d cells need %.3g GB; at most %d floors and %.3g GB fit",
                            most,
                            size,
                            bytes / 1e9,
                            MOST_SHEETS,
                            GridMemory.bytes() / 1e9),
                    "put fewer obstacles above each other, or choose a larger cell");
        }
        return most;
    }

    private static int kept(Column column, double bodyHeight, double[] floors, double[] ceilings, int base) {
        int count = 0;
        for (int i = 0; i < column.size(); i++) {
            double floor = column.top(i);
            double ceiling = column.ceiling(i);
            if (Double.isFinite(floor) && ceiling - floor >= bodyHeight - Column.SAME) {
                if (floors != null) {
                    floors[base + count] = floor;
                    ceilings[base + count] = ceiling;
                }
                count++;
            }
        }
        return count;
    }

    /** Returns the distinct heights, ascending; heights that are the same to {@link Column#SAME} count once. */
    private static double[] distinct(double[] heights) {
        double[] sorted = heights.clone();
        Arrays.sort(sorted);
        int count = 0;
        for (double h : sorted) {
            if (!Double.isNaN(h) && (count == 0 || h - sorted[count - 1] > Column.SAME)) {
                sorted[count++] = h;
            }
        }
        return Arrays.copyOf(sorted, count);
    }

    private static int nearest(double[] sorted, double height) {
        int at = Arrays.binarySearch(sorted, height);
        return at >= 0 ? at : -at - 2;
    }

    /** Returns the frame. */
    public GridFrame frame() {
        return frame;
    }

    /** Returns the number of sheets, at least 1: the most spans that any cell holds. */
    public int sheets() {
        return sheets;
    }

    /** Returns the number of span ids, {@code sheets() * frame().size()}. */
    public int size() {
        return sheets * size;
    }

    /** Tells whether there is a span of this id. */
    public boolean exists(int span) {
        return levels[slot(span)] >= 0;
    }

    /** Returns the elevation in metres of the span's floor; NaN if there is no such span. */
    public double floor(int span) {
        return floors[slot(span)];
    }

    /** Returns the elevation in metres where the span ends above, possibly infinite; NaN if there is no such span. */
    public double ceiling(int span) {
        return ceilings[slot(span)];
    }

    /** Returns the number of the span's floor among {@link #elevation}, -1 if there is no such span. */
    public int level(int span) {
        return levels[slot(span)];
    }

    /** Returns the number of distinct floor elevations. */
    public int levels() {
        return elevations.length;
    }

    /** Returns the elevation in metres of a level; ascending. */
    public double elevation(int level) {
        return elevations[level];
    }

    private int slot(int span) {
        int sheet = sheets == 1 ? 0 : span / size;
        return at[span - sheet * size] * sheets + sheet;
    }

    /** Returns the column number of each cell; the array itself. */
    public int[] columnAt() {
        return at;
    }

    /** Returns how many columns have spans numbered here. */
    public int columns() {
        return columns;
    }

    /** Returns the number of the floor of a column's span among {@link #elevation}, -1 if there is no such span. */
    public int level(int column, int sheet) {
        return levels[column * sheets + sheet];
    }

    /** Returns the elevation of the floor of a span in metres. */
    public double floor(int column, int sheet) {
        return floors[column * sheets + sheet];
    }

    /** Returns the elevation of the ceiling of a span in metres, infinite under the open sky. */
    public double ceiling(int column, int sheet) {
        return ceilings[column * sheets + sheet];
    }

    /**
     * Returns the sheet of the span in column {@code to} that a foot can step to from the span of
     * {@code sheet} in column {@code from}, -1 if there is none: floors within {@code stepHeight}, and room
     * for {@code bodyHeight} above the higher floor under both ceilings. At most one span fits, because
     * bodies are taller than two steps.
     */
    public int linked(int from, int sheet, int to, double stepHeight, double bodyHeight) {
        double floor = floors[from * sheets + sheet];
        double ceiling = ceilings[from * sheets + sheet];
        for (int i = to * sheets, end = i + sheets; i < end; i++) {
            if (Math.abs(floors[i] - floor) <= stepHeight + Column.SAME
                    && Math.min(ceilings[i], ceiling) - Math.max(floors[i], floor) >= bodyHeight - Column.SAME) {
                return i - to * sheets;
            }
        }
        return -1;
    }
}
