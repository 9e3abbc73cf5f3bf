package troupe.grid;

import java.util.Arrays;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Finds out on which spans the actor can stand, and how: which of walking and sidestepping have room, and
 * what is under the foot. The passes write two bytes per span.
 *
 * <p>A body has room where no solid that reaches into {@code (floor + stepHeight, floor + bodyHeight)},
 * nor the world's edge, is nearer to the cell's centre than its radius: each outline stamps the runs of
 * cells within the radius, to the last bit of a double. Where the radius is under {@link #TOUCHING} cells
 * the cells whose open inside such an outline crosses are taken too, so that no wall is so thin that a
 * step leads through it. Source: Unified section 6.2 (C-obstacles).
 */
final class Standing {
    /** Radii under this many cells leave part of a step to a neighbouring cell uncovered. */
    static final double TOUCHING = 0.71;

    private final Scene scene;
    private final Actor actor;
    private final Spans spans;
    private final int cells;
    private final byte[] abilities;
    private final byte[] kinds;

    Standing(Scene scene, Actor actor, Spans spans) {
        this.scene = scene;
        this.actor = actor;
        this.spans = spans;
        this.cells = spans.frame().size();
        this.abilities = new byte[spans.size()];
        this.kinds = new byte[spans.size()];
    }

    /** Finds which abilities have room on each span. */
    void bodies() {
        headRoom();
        CellRuns runs = new CellRuns(spans.frame());
        int walk = Ability.WALK.bit();
        int sidestep = Ability.SIDESTEP.bit();
        double walkRadius = actor.walk().radius();
        edge(runs, walkRadius, walk);
        actor.sidestep().ifPresent(s -> edge(runs, s.radius(), sidestep));
        boolean[] blocked = new boolean[spans.levels()];
        for (Obstacle obstacle : scene.obstacles()) {
            boolean any = false;
            for (int level = 0; level < blocked.length; level++) {
                blocked[level] =
                        RegionBuilder.blocks(obstacle, spans.elevation(level), actor.stepHeight(), actor.bodyHeight());
                any |= blocked[level];
            }
            if (any) {
                outline(runs, obstacle.outline(), blocked, walkRadius, walk);
                actor.sidestep().ifPresent(s -> outline(runs, obstacle.outline(), blocked, s.radius(), sidestep));
            }
        }
    }

    /** Gives every span its kind and the abilities whose bodies fit under its ceiling. */
    private void headRoom() {
        int sheets = spans.sheets();
        byte[] bits = new byte[spans.columns() * sheets];
        int standing = RegionBuilder.standingBits(actor);
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

    /** Returns the ability bits of each span; the array itself. */
    byte[] abilities() {
        return abilities;
    }

    /** Returns the kind of each span; the array itself. */
    byte[] kinds() {
        return kinds;
    }
}
