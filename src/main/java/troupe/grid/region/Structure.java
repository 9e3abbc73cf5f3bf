package troupe.grid.region;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.grid.layer.Columns;
import troupe.grid.layer.Spans;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Holds what all regions of one actor in one scene have in common, wherever its movable obstacles stand:
 * columns, spans, rims, what the actor can do on each span while no movable obstacle is there. Immutable.
 */
record Structure(Scene scene, Actor actor, Columns columns, Spans spans, Standing standing, Solid[] fixed) {

    /** Classifies the spans of a scene as if its movable obstacles were not there. */
    static Structure of(Scene scene, Actor actor, Columns columns, Spans spans) {
        Solid[] fixed = new Solid[scene.obstacles().size()];
        for (int i = 0; i < fixed.length; i++) {
            Obstacle obstacle = scene.obstacles().get(i);
            fixed[i] = obstacle.movable() ? null : new Solid(obstacle, actor, spans.frame());
        }
        Standing standing = new Standing(scene, actor, columns, spans, fixed);
        standing.bodies();
        standing.feet();
        return new Structure(scene, actor, columns, spans, standing, fixed);
    }

    /** Returns for each obstacle of the scene a movable one at its own outline, null for the others; a new array. */
    Solid[] movables() {
        Solid[] movables = new Solid[fixed.length];
        for (int i = 0; i < fixed.length; i++) {
            if (fixed[i] == null) {
                movables[i] = new Solid(scene.obstacles().get(i), actor, spans.frame());
            }
        }
        return movables;
    }

    /** Returns a movable obstacle that stands at another outline. */
    Solid placed(int obstacle, Polygon outline) {
        return new Solid(movable(obstacle).withOutline(outline), actor, spans.frame());
    }

    /**
     * Returns a movable obstacle of the scene.
     *
     * @throws IllegalArgumentException if there is no obstacle of that index, or it is immovable
     */
    Obstacle movable(int obstacle) {
        if (obstacle < 0 || obstacle >= fixed.length || fixed[obstacle] != null) {
            throw new IllegalArgumentException("obstacle " + obstacle + "; needs the index of a movable one of the "
                    + fixed.length + " obstacles");
        }
        return scene.obstacles().get(obstacle);
    }

    /** Returns everything that stands in the scene: the immovable obstacles and the movable ones that are there. */
    List<Solid> solids(Solid[] movables) {
        List<Solid> solids = new ArrayList<>();
        for (int i = 0; i < fixed.length; i++) {
            if (fixed[i] != null) {
                solids.add(fixed[i]);
            } else if (movables[i] != null) {
                solids.add(movables[i]);
            }
        }
        return solids;
    }
}
