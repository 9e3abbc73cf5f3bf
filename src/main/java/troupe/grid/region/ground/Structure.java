package troupe.grid.region.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import troupe.geometry.Polygon;
import troupe.grid.layer.Columns;
import troupe.grid.layer.Spans;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Holds what all regions of one actor in one scene have in common, wherever its movable obstacles stand:
 * columns, spans, rims, how one stands on each span and what can be crossed while none of them is there.
 * Immutable to those who use it; safe for any thread.
 */
public final class Structure {
    private final Scene scene;
    private final Actor actor;
    private final Columns columns;
    private final Spans spans;
    private final Solid[] immovable;
    private final Standing standing;
    private final Solids fixed;
    private final CrossingSurvey survey;

    /** Classifies the spans of a scene as if its movable obstacles were not there. Cost O(cells + edges). */
    public Structure(Scene scene, Actor actor, Columns columns, Spans spans) {
        this.scene = scene;
        this.actor = actor;
        this.columns = columns;
        this.spans = spans;
        this.immovable = new Solid[scene.obstacles().size()];
        for (int i = 0; i < immovable.length; i++) {
            Obstacle obstacle = scene.obstacles().get(i);
            immovable[i] = obstacle.movable() ? null : new Solid(obstacle, actor, spans.frame());
        }
        this.standing = new Standing(scene, actor, columns, spans, immovable);
        standing.bodies();
        standing.feet();
        if (crosses()) {
            this.fixed = new Solids(scene, actor, columns, standing.rims(), present(immovable), spans.frame());
            this.survey = new CrossingSurvey(scene, actor, columns, spans, standing, fixed.about(present(immovable)));
        } else {
            this.fixed = null;
            this.survey = null;
        }
    }

    private Structure(Structure other, Scene scene) {
        this.scene = scene;
        this.actor = other.actor;
        this.columns = other.columns;
        this.spans = other.spans;
        this.immovable = other.immovable;
        this.standing = other.standing;
        this.fixed = other.fixed;
        this.survey = other.survey;
    }

    /** Returns the same for a scene that differs in the outlines of movable obstacles only. */
    public Structure of(Scene moved) {
        return new Structure(this, moved);
    }

    /** Tells whether the actor can stride or vault at all; only then there are {@link #fixed} and {@link #survey}. */
    public boolean crosses() {
        return actor.stride().isPresent() || actor.vault().isPresent();
    }

    /** Returns the scene. */
    public Scene scene() {
        return scene;
    }

    /** Returns the actor profile. */
    public Actor actor() {
        return actor;
    }

    /** Returns what is solid over each cell. */
    public Columns columns() {
        return columns;
    }

    /** Returns the floors over each cell, with their ceilings. */
    public Spans spans() {
        return spans;
    }

    /** Returns where the immovable obstacles let one stand. */
    public Standing standing() {
        return standing;
    }

    /** Returns the questions about the immovable obstacles, for other obstacles to be asked by {@link Solids#about}. */
    public Solids fixed() {
        return fixed;
    }

    /** Returns where one can take off, as the immovable obstacles have it. */
    public CrossingSurvey survey() {
        return survey;
    }

    /** Returns for each obstacle of the scene a movable one at its own outline, null for the others; a new array. */
    public Solid[] movables() {
        Solid[] movables = new Solid[immovable.length];
        for (int i = 0; i < immovable.length; i++) {
            if (immovable[i] == null) {
                movables[i] = new Solid(scene.obstacles().get(i), actor, spans.frame());
            }
        }
        return movables;
    }

    /** Returns that no movable obstacle is there, as {@link #movables} would say it; a new array. */
    public Solid[] none() {
        return new Solid[immovable.length];
    }

    /** Returns a movable obstacle that stands at another outline. */
    public Solid placed(int obstacle, Polygon outline) {
        return new Solid(movable(obstacle).withOutline(outline), actor, spans.frame());
    }

    /**
     * Returns a movable obstacle of the scene.
     *
     * @throws IllegalArgumentException if there is no obstacle of that index, or it is immovable
     */
    public Obstacle movable(int obstacle) {
        if (obstacle < 0 || obstacle >= immovable.length || immovable[obstacle] != null) {
            throw new IllegalArgumentException("obstacle " + obstacle + "; needs the index of a movable one of the "
                    + immovable.length + " obstacles");
        }
        return scene.obstacles().get(obstacle);
    }

    /** Returns everything that stands in the scene: the immovable obstacles and the movable ones that are there. */
    public List<Solid> solids(Solid[] movables) {
        List<Solid> solids = new ArrayList<>();
        for (int i = 0; i < immovable.length; i++) {
            if (immovable[i] != null) {
                solids.add(immovable[i]);
            } else if (movables[i] != null) {
                solids.add(movables[i]);
            }
        }
        return solids;
    }

    /** Returns the solids that are there. */
    public static List<Solid> present(Solid[] solids) {
        return Arrays.stream(solids).filter(Objects::nonNull).toList();
    }
}
