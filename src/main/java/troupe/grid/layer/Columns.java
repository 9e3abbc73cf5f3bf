package troupe.grid.layer;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import troupe.grid.CellRuns;
import troupe.grid.GridFrame;
import troupe.grid.GridLimitException;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Numbers the distinct columns of a scene and finds the column of every cell. A scene has few distinct
 * columns (one for each way in which polygons overlap), so a cell holds one number, and what is asked of
 * heights is asked once per column. Movable obstacles are no part of it: the bodies that they bar are marked
 * afterwards. The maps are only looked up, never iterated.
 */
public final class Columns {
    /** The number of the column that is solid all the way up. */
    public static final int ROCK = 0;

    /** What a column takes besides its stretches, in stretches. */
    private static final int OVERHEAD = 16;

    /** The most stretches of all columns together; about 140 MB. */
    private static final long MOST_STRETCHES = 1L << 23;

    private final List<Column> table = new ArrayList<>();
    private final Map<Column, Integer> numbers = new HashMap<>();
    private final Map<Long, Integer> raised = new HashMap<>();
    private final Map<Solid, Integer> solids = new HashMap<>();
    private final int[] at;

    private long stretches;

    private record Solid(double bottom, double top) {}

    /**
     * Finds the column of each cell of the frame; cells whose centre lies outside the world are rock.
     *
     * @throws GridLimitException if the obstacles overlap in so many ways that the columns do not fit
     */
    public Columns(GridFrame frame, Scene scene) {
        this.at = new int[frame.size()];
        number(Column.rock());
        CellRuns runs = new CellRuns(frame);
        runs.inside(scene.world());
        int flat = number(Column.ground(0));
        for (int i = 0; i < runs.size(); i++) {
            java.util.Arrays.fill(at, runs.from(i), runs.to(i), flat);
        }
        for (Ditch ditch : scene.ditches()) {
            runs.clear();
            runs.fill(ditch.outline());
            apply(runs, id -> dug(id, ditch));
        }
        for (Obstacle obstacle : scene.obstacles()) {
            if (obstacle.movable()) {
                continue;
            }
            runs.clear();
            runs.fill(obstacle.outline());
            int solid = solid(obstacle);
            apply(runs, id -> raised(id, solid, obstacle));
        }
    }

    private void apply(CellRuns runs, java.util.function.IntUnaryOperator change) {
        int from = ROCK;
        int to = ROCK;
        for (int i = 0; i < runs.size(); i++) {
            for (int cell = runs.from(i), end = runs.to(i); cell < end; cell++) {
                if (at[cell] != from) {
                    from = at[cell];
                    to = change.applyAsInt(from);
                }
                at[cell] = to;
            }
        }
    }

    /** Returns the number of a column of bare ground with a ditch dug into it. */
    public int dug(int id, Ditch ditch) {
        return id == ROCK ? ROCK : number(Column.ground(Math.min(column(id).ground(), -ditch.depth())));
    }

    /** Returns the number of a column with an obstacle put in. */
    public int raised(int id, Obstacle obstacle) {
        return raised(id, solid(obstacle), obstacle);
    }

    private int solid(Obstacle obstacle) {
        Solid solid = new Solid(obstacle.offset(), obstacle.top());
        return solids.computeIfAbsent(solid, s -> solids.size());
    }

    private int raised(int id, int solid, Obstacle obstacle) {
        if (id == ROCK) {
            return ROCK;
        }
        Integer known = raised.get((long) solid << 32 | id);
        if (known == null) {
            known = number(column(id).with(obstacle.offset(), obstacle.top()));
            raised.put((long) solid << 32 | id, known);
        }
        return known;
    }

    private int number(Column column) {
        Integer known = numbers.get(column);
        if (known == null) {
            stretches += column.size() + OVERHEAD;
            if (stretches > Math.min(MOST_STRETCHES, Runtime.getRuntime().maxMemory() / 128)) {
                throw new GridLimitException(
                        "obstacles overlap in more than " + table.size() + " ways",
                        "take some away where many lie over each other, or choose a larger cell");
            }
            known = table.size();
            table.add(column);
            numbers.put(column, known);
        }
        return known;
    }

    /** Returns the number of bare ground at elevation 0. */
    public int flat() {
        return number(Column.ground(0));
    }

    /** Returns how many columns have been numbered. */
    public int count() {
        return table.size();
    }

    /** Returns the column of a number. */
    public Column column(int id) {
        return table.get(id);
    }

    /** Returns the column number of each cell; the array itself. */
    public int[] at() {
        return at;
    }
}
