package troupe.grid.region.ground;

import java.util.Arrays;
import troupe.geometry.Polygon;
import troupe.grid.CellRuns;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.grid.layer.Columns;
import troupe.grid.layer.Spans;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Scene;

/**
 * Finds out on which spans the actor can stand, and how: which of walking and sidestepping have room, and
 * what is under the foot. The passes write two bytes per span.
 *
 * <p>A body has room where no solid that reaches into {@code (floor + stepHeight, floor + bodyHeight)},
 * nor the world's edge, is nearer to the cell's centre than its radius: each outline stamps the runs of
 * cells within the radius, exact to 1e-9 m. Where the radius is under {@link #TOUCHING} cells
 * the cells whose open inside such an outline crosses are taken too, so that no wall is so thin that a
 * step leads through it. Source: Unified section 6.2 (C-obstacles).
 */
public final class Standing {
    /** Radii under this many cells leave part of a step to a neighbouring cell uncovered. */
    public static final double TOUCHING = 0.71;

    private static final int EDGE = 1;
    private static final int DROP = 2;

    private final Scene scene;
    private final Actor actor;
    private final Columns columns;
    private final Spans spans;
    private final Rims rims;
    private final int cells;
    private final byte[] abilities;
    private final byte[] kinds;
    private final Solid[] solids;

    /** Prepares the passes; {@code solids} are the immovable obstacles, null for movable ones. */
    public Standing(Scene scene, Actor actor, Columns columns, Spans spans, Solid[] solids) {
        this.scene = scene;
        this.actor = actor;
        this.columns = columns;
        this.spans = spans;
        this.rims = new Rims(scene, columns, actor.footRadius() > 0);
        this.cells = spans.frame().size();
        this.abilities = new byte[spans.size()];
        this.kinds = new byte[spans.size()];
        this.solids = solids;
    }

    /** Finds which abilities have room on each span. */
    public void bodies() {
        headRoom();
        CellRuns runs = new CellRuns(spans.frame());
        int walk = Ability.WALK.bit();
        int sidestep = Ability.SIDESTEP.bit();
        double walkRadius = actor.walk().radius();
        edge(runs, walkRadius, walk);
        ditchWalls(runs, walkRadius, walk);
        actor.sidestep().ifPresent(s -> {
            edge(runs, s.radius(), sidestep);
            ditchWalls(runs, s.radius(), sidestep);
        });
        boolean[] blocked = new boolean[spans.levels()];
        for (Solid solid : solids) {
            if (solid != null && blocked(solid, blocked)) {
                runs.clear();
                runs.add(solid.near());
                take(runs, blocked, walk);
                actor.sidestep().ifPresent(s -> outline(runs, solid.outline(), blocked, s.radius(), sidestep));
            }
        }
    }

    /** Finds the levels on which a solid is in the way of a body; returns whether there are any. */
    private boolean blocked(Solid solid, boolean[] blocked) {
        boolean any = false;
        for (int level = 0; level < blocked.length; level++) {
            blocked[level] = solid.blocks(spans.elevation(level));
            any |= blocked[level];
        }
        return any;
    }

    /** Returns the words of the spans while no movable obstacle is there; steps are not in them yet. */
    public Words words() {
        return Words.of(abilities, kinds);
    }

    /** Writes the abilities of the spans over a window of cells anew, with movable obstacles where they stand. */
    public void stand(Solid[] movables, Window window, Words words) {
        for (int sheet = 0; sheet < spans.sheets(); sheet++) {
            for (int row = window.row0(); row < window.row0() + window.rows(); row++) {
                int q = sheet * cells + row * spans.frame().cols() + window.col0();
                for (int end = q + window.cols(); q < end; q++) {
                    words.set(q, words.get(q) | abilities[q]);
                }
            }
        }
        bar(movables, window, words);
    }

    /** Takes abilities from the spans over a window of cells that movable obstacles bar. */
    public void bar(Solid[] movables, Window window, Words words) {
        CellRuns runs = new CellRuns(spans.frame());
        boolean[] blocked = new boolean[spans.levels()];
        for (Solid solid : movables) {
            if (solid != null && solid.box().meets(window) && blocked(solid, blocked)) {
                runs.clear();
                runs.add(solid.cover());
                bar(words, runs, window, blocked, Ability.WALK.bit());
                if (actor.sidestep().isPresent()) {
                    runs.clear();
                    runs.add(solid.sidestepCover());
                    bar(words, runs, window, blocked, Ability.SIDESTEP.bit());
                }
            }
        }
    }

    private void bar(Words words, CellRuns runs, Window window, boolean[] blocked, int bit) {
        int[] at = spans.columnAt();
        int cols = spans.frame().cols();
        for (int i = 0; i < runs.size(); i++) {
            int row = runs.from(i) / cols;
            if (row < window.row0() || row >= window.row0() + window.rows()) {
                continue;
            }
            int end = Math.min(runs.to(i), row * cols + window.col0() + window.cols());
            for (int cell = Math.max(runs.from(i), row * cols + window.col0()); cell < end; cell++) {
                for (int sheet = 0; sheet < spans.sheets(); sheet++) {
                    int level = spans.level(at[cell], sheet);
                    if (level >= 0 && blocked[level]) {
                        int q = sheet * cells + cell;
                        words.set(q, words.get(q) & ~bit);
                    }
                }
            }
        }
    }

    private int standingBits() {
        return Ability.WALK.bit() | (actor.sidestep().isPresent() ? Ability.SIDESTEP.bit() : 0);
    }

    /** Gives every span its kind and the abilities whose bodies fit under its ceiling. */
    private void headRoom() {
        int sheets = spans.sheets();
        byte[] bits = new byte[spans.columns() * sheets];
        int standing = standingBits();
        for (int i = 0; i < bits.length; i++) {
            double room = spans.ceiling(i / sheets, i % sheets) - spans.floor(i / sheets, i % sheets);
            bits[i] = (byte) (room >= actor.bodyHeight() - Column.SAME ? standing : 0);
        }
        int[] at = spans.columnAt();
        for (int sheet = 0; sheet < sheets; sheet++) {
            int base = sheet * cells;
            for (int cell = 0; cell < cells; cell++) {
                int column = at[cell];
                if (column != Columns.ROCK && spans.level(column, sheet) >= 0) {
                    kinds[base + cell] = Kind.STABLE;
                    abilities[base + cell] = bits[column * sheets + sheet];
                }
            }
        }
    }

    private void edge(CellRuns runs, double radius, int bit) {
        runs.clear();
        runs.nearEdge(scene.world(), radius);
        if (touching(radius)) {
            runs.touch(
                    Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth()));
        }
        boolean[] all = new boolean[spans.levels()];
        Arrays.fill(all, true);
        take(runs, all, bit);
    }

    private void outline(CellRuns runs, Polygon outline, boolean[] blocked, double radius, int bit) {
        runs.clear();
        runs.near(outline, radius);
        if (touching(radius)) {
            runs.touch(outline);
        }
        take(runs, blocked, bit);
    }

    /** Takes an ability near the walls of ditches: pieces where the ground rises above a floor and its step. */
    private void ditchWalls(CellRuns runs, double radius, int bit) {
        boolean[] blocked = new boolean[spans.levels()];
        for (int i = 0; i < rims.size(); i++) {
            double left = columns.column(rims.left(i)).ground();
            double right = columns.column(rims.right(i)).ground();
            if (left == right) {
                continue;
            }
            for (int level = 0; level < blocked.length; level++) {
                double limit = spans.elevation(level) + actor.stepHeight() + Column.SAME;
                blocked[level] = Math.min(left, right) <= limit && Math.max(left, right) > limit;
            }
            runs.clear();
            rims.near(i, radius, runs);
            if (touching(radius)) {
                rims.touch(i, runs);
            }
            take(runs, blocked, bit);
        }
    }

    /**
     * Looks under the foot disc of each span: where it holds a floor within a step of the span's own but
     * not the same, the span is a border; where it holds one deeper than a step, nobody stands there.
     * A point where a solid stands in the body's way says nothing about support.
     */
    public void feet() {
        CellRuns runs = new CellRuns(spans.frame());
        byte[] under = new byte[spans.levels()];
        for (int i = 0; i < rims.size(); i++) {
            int worst = 0;
            for (int level = 0; level < under.length; level++) {
                under[level] = (byte) Math.max(under(rims.left(i), level), under(rims.right(i), level));
                worst = Math.max(worst, under[level]);
            }
            if (worst > 0) {
                runs.clear();
                rims.near(i, actor.footRadius(), runs);
                mark(runs, under);
            }
        }
    }

    private int under(int column, int level) {
        double floor = spans.elevation(level);
        Column solids = columns.column(column);
        if (solids.meets(floor + actor.stepHeight(), floor + actor.bodyHeight())) {
            return 0;
        }
        double surface = solids.highestTop(floor + actor.stepHeight());
        if (surface < floor - actor.stepHeight() - Column.SAME) {
            return DROP;
        }
        return Math.abs(surface - floor) > Column.SAME ? EDGE : 0;
    }

    private void mark(CellRuns runs, byte[] under) {
        int[] at = spans.columnAt();
        int sheets = spans.sheets();
        for (int i = 0; i < runs.size(); i++) {
            for (int cell = runs.from(i), end = runs.to(i); cell < end; cell++) {
                for (int sheet = 0; sheet < sheets; sheet++) {
                    int level = spans.level(at[cell], sheet);
                    int q = sheet * cells + cell;
                    if (level < 0 || under[level] == 0) {
                        continue;
                    }
                    if (under[level] == DROP) {
                        kinds[q] = Kind.FORBIDDEN;
                        abilities[q] = 0;
                    } else if (kinds[q] == Kind.STABLE) {
                        kinds[q] = Kind.BORDER;
                    }
                }
            }
        }
    }

    private boolean touching(double radius) {
        return radius < TOUCHING * spans.frame().cell();
    }

    /** Takes an ability from the spans of the runs' cells whose floor is one of the blocked levels. */
    private void take(CellRuns runs, boolean[] blocked, int bit) {
        int[] at = spans.columnAt();
        int sheets = spans.sheets();
        for (int i = 0; i < runs.size(); i++) {
            for (int cell = runs.from(i), end = runs.to(i); cell < end; cell++) {
                for (int sheet = 0; sheet < sheets; sheet++) {
                    int level = spans.level(at[cell], sheet);
                    if (level >= 0 && blocked[level]) {
                        abilities[sheet * cells + cell] &= (byte) ~bit;
                    }
                }
            }
        }
    }

    /** Returns the pieces of outlines where floors or ground change. */
    public Rims rims() {
        return rims;
    }

    /** Returns the ability bits of each span; the array itself. */
    public byte[] abilities() {
        return abilities;
    }

    /** Returns the kind of each span, forbidden where it is over a drop; the array itself. */
    public byte[] kinds() {
        return kinds;
    }
}
