package troupe.grid.region.ground;

import troupe.geometry.Polygon;
import troupe.grid.CellRuns;
import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.scene.Actor;
import troupe.scene.Obstacle;

/**
 * Holds an obstacle where it stands and the cells that it bars to an actor, as runs of {@link CellRuns} that
 * are found when first asked for. An immovable one is in the way of a body from a step above the floor on,
 * because lower ones carry; a movable one, whose top carries nobody, from the floor itself on. Immutable to
 * those who use it; may be shared between regions and threads.
 */
public final class Solid {
    private final Obstacle obstacle;
    private final Actor actor;
    private final GridFrame frame;
    private final Window box;
    private volatile int[] near;
    private volatile int[] cover;
    private volatile int[] sidestepCover;

    /** Makes the solid of an obstacle that stands at its own outline. */
    public Solid(Obstacle obstacle, Actor actor, GridFrame frame) {
        this.obstacle = obstacle;
        this.actor = actor;
        this.frame = frame;
        this.box =
                Window.of(frame, obstacle.outline().bounds().grown(actor.walk().radius()));
    }

    /** Returns the obstacle; its outline is where it stands. */
    public Obstacle obstacle() {
        return obstacle;
    }

    /** Returns where it stands, in metres. */
    public Polygon outline() {
        return obstacle.outline();
    }

    /** Returns the height of its top over the world, in metres. */
    public double top() {
        return obstacle.top();
    }

    /** Returns a window that holds every cell which the solid bars. */
    public Window box() {
        return box;
    }

    /** Tells whether the solid reaches into the stretch of a walking body on a floor. */
    public boolean blocks(double floor) {
        double low = obstacle.movable() ? floor : floor + actor.stepHeight();
        return obstacle.offset() < floor + actor.bodyHeight() - Column.SAME && obstacle.top() > low + Column.SAME;
    }

    /** Tells whether the solid may hang in the way of a body that vaults from a floor. */
    public boolean hangsAbove(double floor) {
        return actor.vault().isPresent()
                && obstacle.offset() >= floor + actor.bodyHeight() - Column.SAME
                && obstacle.offset()
                        < floor
                                + actor.vault().get().maxHeight()
                                + actor.vault().get().bodyHeight();
    }

    /** Tells whether hands can push off from its top on a vault from a floor. */
    public boolean inRange(double floor, Actor.Vault vault) {
        return inRange(obstacle.top(), floor, vault) && obstacle.top() > floor + actor.stepHeight() + Column.SAME;
    }

    /** Tells whether a top, in metres, can be vaulted by a body that takes off from a floor. */
    public static boolean inRange(double top, double floor, Actor.Vault vault) {
        return top >= floor + vault.minHeight() - Column.SAME && top <= floor + vault.maxHeight() + Column.SAME;
    }

    /** Returns the cells within the walk radius of the outline, or touched by it. */
    public int[] near() {
        int[] known = near;
        if (known == null) {
            CellRuns runs = new CellRuns(frame);
            add(runs, actor.walk().radius());
            known = runs.copy();
            near = known;
        }
        return known;
    }

    /** Returns the cells of {@link #near} and those whose centre lies inside the outline. */
    public int[] cover() {
        int[] known = cover;
        if (known == null) {
            CellRuns runs = new CellRuns(frame);
            runs.add(near());
            runs.fill(outline());
            known = runs.copy();
            cover = known;
        }
        return known;
    }

    /** Returns the cells within the sidestep radius of the filled outline, or touched by it. */
    public int[] sidestepCover() {
        int[] known = sidestepCover;
        if (known == null) {
            CellRuns runs = new CellRuns(frame);
            add(runs, actor.sidestep().orElseThrow().radius());
            runs.fill(outline());
            known = runs.copy();
            sidestepCover = known;
        }
        return known;
    }

    /** Returns the cells that a gap may not pass: all that it bars, without those that their columns already bar. */
    public int[] barsGaps() {
        return obstacle.movable() ? cover() : near();
    }

    private void add(CellRuns runs, double radius) {
        runs.near(outline(), radius);
        if (radius < Standing.TOUCHING * frame.cell()) {
            runs.touch(outline());
        }
    }
}
