package troupe.grid.region;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import troupe.grid.layer.Layers;
import troupe.grid.layer.Spans;
import troupe.grid.region.crossing.WidestVaults;
import troupe.grid.region.ground.Structure;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Builds the configurations of one actor profile in the paper's stages, one call each, so that each can
 * be timed: {@link #layers} and then {@link #region}. Each runs once, and first what it needs. An instance
 * belongs to one thread; what it hands out is immutable.
 *
 * <p>Source: Unified sections 3, 5 and 7; deviations are listed in {@code docs/grid.md}.
 */
public final class RegionBuilder {
    private final Scene scene;
    private final Actor actor;
    private final Groundwork groundwork;
    private Structure structure;
    private Region region;
    private Region widest;
    private ForkJoinTask<Region> begun;

    /** Makes a builder for an actor that has already lost the abilities which preferences switch off. */
    public RegionBuilder(Scene scene, Actor actor) {
        this(scene, actor, new Groundwork(scene, actor));
    }

    /**
     * Makes a builder that shares what does not depend on where movable obstacles stand. What it builds is the same.
     *
     * @throws IllegalArgumentException if the groundwork does not fit the scene and the actor
     */
    public RegionBuilder(Scene scene, Actor actor, Groundwork groundwork) {
        if (!groundwork.fits(scene, actor)) {
            throw new IllegalArgumentException("the groundwork is of another scene or actor than '" + actor.id()
                    + "'; only movable obstacles may stand elsewhere");
        }
        this.scene = scene;
        this.actor = actor;
        this.groundwork = groundwork;
    }

    /** Finds the spans of the scene. Cost O(cells + edges). */
    public Spans spans() {
        return groundwork.spans();
    }

    /** Numbers the layers of the spans. Cost O(spans). */
    public Layers layers() {
        return groundwork.layers();
    }

    /** Classifies every configuration, movable obstacles at their own places. Cost O(cells + edges). */
    public Region region() {
        if (region == null) {
            region = groundwork.region(structure());
        }
        return region;
    }

    private Structure structure() {
        if (structure == null) {
            structure = groundwork.structure(scene);
        }
        return structure;
    }

    /**
     * Begins to build {@link #widest} on another thread, if there is one to spare and something can be moved; what it is
     * does not depend on it.
     */
    public void beginWidest() {
        structure();
        if (isWidened() && widest == null && begun == null) {
            begun = ForkJoinPool.commonPool().submit(groundwork::widest);
        }
    }

    /** Tells whether another thread is building {@link #widest} now, so that it would be waited for. */
    public boolean isBuildingWidest() {
        return begun != null && !begun.isDone();
    }

    /** Tells whether the actor can move something that the scene has to be moved. */
    private boolean isWidened() {
        return actor.move().isPresent() && scene.obstacles().stream().anyMatch(Obstacle::movable);
    }

    /**
     * Finds the region that bounds all that can arise by moving obstacles: whatever stands where, each way is also
     * one here, at no more cost if standing steps cost no more than vaulting ones. It has the spans and gaps of
     * the region without any movable obstacle, and vaults that need not lie on a straight crossing ({@link
     * WidestVaults}). A place on a vault of another region answers to the crossing of the same cell, level and kind
     * here, or, where there is none or that is cheaper, to the span within a step of that level. It is not to be
     * patched. The very object of {@link #region} if none can be moved, because the actor cannot or the scene has
     * none to move.
     */
    public Region widest() {
        if (widest == null) {
            widest = begun != null ? begun.join() : isWidened() ? groundwork.widest() : region();
        }
        return widest;
    }

    /** Returns the region in which no movable obstacle is there. */
    public Region bare() {
        return groundwork.bare(region());
    }
}
