package troupe.grid.region.ground;

import java.util.List;
import java.util.concurrent.CancellationException;
import troupe.grid.CellRuns;
import troupe.grid.DistanceTransform;
import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.grid.layer.Columns;
import troupe.grid.layer.Spans;
import troupe.scene.Actor;
import troupe.scene.Scene;

/**
 * Holds the clearance of every span of a standing body, computed as a whole when it is first asked for.
 * Per floor elevation a distance transform in a window around its spans, which grows until no solid
 * outside it can be nearer, bounds the distance to 0.71 cells; outlines and pieces then write the exact
 * distance within a band of the largest radius and two cells. May be shared between threads. A thread that is
 * interrupted meanwhile gets a {@link CancellationException}; the clearance is then computed when next asked for.
 */
public final class Clearance {
    private static final int FIRST_MARGIN = 16;
    private static final byte OUTLINE = 1;
    private static final byte CENTRE = 2;

    private final Scene scene;
    private final Actor actor;
    private final Columns columns;
    private final Spans spans;
    private final Rims rims;
    private final List<Solid> solids;
    private final GridFrame frame;
    private volatile float[] field;

    /** Prepares the distances for a structure with movable obstacles where they stand; they are worked out when first asked for. */
    public Clearance(Structure structure, Solid[] movables) {
        this.scene = structure.scene();
        this.actor = structure.actor();
        this.columns = structure.columns();
        this.spans = structure.spans();
        this.rims = structure.standing().rims();
        this.solids = structure.solids(movables);
        this.frame = spans.frame();
    }

    /** Returns the clearance in metres of a span, 0 where there is none. */
    public float of(int span) {
        float[] known = field;
        return (known == null ? whole() : known)[span];
    }

    private synchronized float[] whole() {
        if (field == null) {
            float[] made = new float[spans.size()];
            double band = Math.max(
                            actor.walk().radius(),
                            actor.sidestep().map(Actor.Sidestep::radius).orElse(0.0))
                    + 2 * frame.cell();
            for (int level = 0; level < spans.levels(); level++) {
                if (Thread.currentThread().isInterrupted()) {
                    throw new CancellationException("interrupted before the clearance was known");
                }
                bound(level, made, (float) band);
            }
            edge(made);
            exact(made, band);
            field = made;
        }
        return field;
    }

    /** Writes for the spans of one level the bound of the distance transform, but at least {@code least}. */
    private void bound(int level, float[] made, float least) {
        Window spansOfLevel = extent(level);
        if (spansOfLevel.size() == 0) {
            return;
        }
        for (int margin = FIRST_MARGIN; ; margin *= 2) {
            Window window = spansOfLevel.grown(margin, frame);
            int[] squared = new int[window.size()];
            byte[] sources = sources(level, window);
            new DistanceTransform(window.cols(), window.rows()).compute(sources, squared);
            clearAtSources(sources, squared);
            boolean whole = window.size() == frame.size();
            if (write(level, window, squared, whole ? Integer.MAX_VALUE : margin * margin, made, least)) {
                return;
            }
        }
    }

    /** Marks with -1 where the centre itself is in a solid. */
    private static void clearAtSources(byte[] sources, int[] squared) {
        for (int i = 0; i < sources.length; i++) {
            if ((sources[i] & CENTRE) != 0) {
                squared[i] = -1;
            }
        }
    }

    private Window extent(int level) {
        int[] at = spans.columnAt();
        int left = frame.cols();
        int low = frame.rows();
        int right = -1;
        int high = -1;
        for (int cell = 0; cell < at.length; cell++) {
            for (int sheet = 0; sheet < spans.sheets(); sheet++) {
                if (spans.level(at[cell], sheet) == level) {
                    left = Math.min(left, frame.col(cell));
                    right = Math.max(right, frame.col(cell));
                    low = Math.min(low, frame.row(cell));
                    high = frame.row(cell);
                }
            }
        }
        return new Window(left, low, Math.max(0, right - left + 1), Math.max(0, high - low + 1));
    }

    /** Returns the cells of a window that hold, at their centre or on an outline, a solid in the body's way. */
    private byte[] sources(int level, Window window) {
        byte[] sources = new byte[window.size()];
        double floor = spans.elevation(level);
        boolean[] blocked = new boolean[spans.columns()];
        for (int column = 0; column < blocked.length; column++) {
            blocked[column] = columns.column(column).meets(floor + actor.stepHeight(), floor + actor.bodyHeight());
        }
        for (int i = 0; i < sources.length; i++) {
            int row = i / window.cols();
            int cell = (window.row0() + row) * frame.cols() + window.col0() + i - row * window.cols();
            sources[i] = blocked[spans.columnAt()[cell]] ? CENTRE : 0;
        }
        CellRuns runs = new CellRuns(frame);
        for (Solid solid : solids) {
            if (solid.blocks(floor)) {
                runs.touch(solid.outline());
                if (solid.obstacle().movable()) {
                    inside(solid, window, sources);
                }
            }
        }
        for (int i = 0; i < rims.size(); i++) {
            if (wall(i, floor)) {
                rims.touch(i, runs);
            }
        }
        window.each(runs, frame, (from, to) -> {
            for (int i = from; i < to; i++) {
                sources[i] |= OUTLINE;
            }
        });
        return sources;
    }

    /** Marks the cells of a window whose centre lies inside a movable obstacle, of which columns do not know. */
    private void inside(Solid solid, Window window, byte[] sources) {
        CellRuns runs = new CellRuns(frame);
        runs.fill(solid.outline());
        window.each(runs, frame, (from, to) -> {
            for (int i = from; i < to; i++) {
                sources[i] |= CENTRE;
            }
        });
    }

    /** Tells whether the ground rises in the way of a body on {@code floor} at a piece. */
    private boolean wall(int piece, double floor) {
        double left = columns.column(rims.left(piece)).ground();
        double right = columns.column(rims.right(piece)).ground();
        double limit = floor + actor.stepHeight() + Column.SAME;
        return Math.min(left, right) <= limit && Math.max(left, right) > limit;
    }

    private boolean write(int level, Window window, int[] squared, int sure, float[] made, float least) {
        int[] at = spans.columnAt();
        for (int i = 0; i < squared.length; i++) {
            int row = i / window.cols();
            int cell = (window.row0() + row) * frame.cols() + window.col0() + i - row * window.cols();
            for (int sheet = 0; sheet < spans.sheets(); sheet++) {
                if (spans.level(at[cell], sheet) == level) {
                    if (squared[i] > sure) {
                        return false;
                    }
                    made[sheet * frame.size() + cell] =
                            squared[i] < 0 ? 0 : Math.max(least, (float) (Math.sqrt(squared[i]) * frame.cell()));
                }
            }
        }
        return true;
    }

    private void edge(float[] made) {
        for (int q = 0; q < made.length; q++) {
            if (made[q] > 0) {
                double x = frame.centreX(frame.col(q % frame.size()));
                double y = frame.centreY(frame.row(q % frame.size()));
                double edge = Math.min(
                        Math.min(x, scene.world().width() - x),
                        Math.min(y, scene.world().depth() - y));
                made[q] = Math.min(made[q], (float) edge);
            }
        }
    }

    private void exact(float[] made, double band) {
        CellRuns runs = new CellRuns(frame);
        boolean[] blocked = new boolean[spans.levels()];
        for (Solid solid : solids) {
            for (int level = 0; level < blocked.length; level++) {
                blocked[level] = solid.blocks(spans.elevation(level));
            }
            runs.clear();
            runs.near(solid.outline(), band);
            stamp(runs, blocked, made, (x, y) -> solid.outline().distanceToOutline(x, y));
        }
        for (int i = 0; i < rims.size(); i++) {
            for (int level = 0; level < blocked.length; level++) {
                blocked[level] = wall(i, spans.elevation(level));
            }
            int piece = i;
            runs.clear();
            rims.near(i, band, runs);
            stamp(runs, blocked, made, (x, y) -> Math.sqrt(rims.distanceSquared(piece, x, y)));
        }
    }

    private interface Distance {
        double from(double x, double y);
    }

    private void stamp(CellRuns runs, boolean[] blocked, float[] made, Distance distance) {
        int[] at = spans.columnAt();
        for (int i = 0; i < runs.size(); i++) {
            for (int cell = runs.from(i); cell < runs.to(i); cell++) {
                for (int sheet = 0; sheet < spans.sheets(); sheet++) {
                    int level = spans.level(at[cell], sheet);
                    int q = sheet * frame.size() + cell;
                    if (level >= 0 && blocked[level] && made[q] > 0) {
                        double d = distance.from(frame.centreX(frame.col(cell)), frame.centreY(frame.row(cell)));
                        made[q] = Math.min(made[q], (float) d);
                    }
                }
            }
        }
    }
}
