package troupe.grid.region;

import java.util.ArrayList;
import java.util.List;
import troupe.scene.Actor;
import troupe.scene.Scene;

/**
 * Keeps the groundwork of the last few plans, so that a plan of a scene in which only a movable obstacle has been put
 * somewhere else need not begin from nothing. No result depends on what is kept. Safe for any thread.
 */
public final class Groundworks {
    private static final int KEPT = 4;

    private final List<Groundwork> kept = new ArrayList<>();

    /** Keeps nothing yet. */
    public Groundworks() {}

    /** Returns the groundwork of an actor in a scene: one that is kept if it fits, else a new one, which is kept then. */
    public synchronized Groundwork of(Scene scene, Actor actor) {
        for (int i = kept.size() - 1; i >= 0; i--) {
            if (kept.get(i).fits(scene, actor)) {
                Groundwork found = kept.remove(i);
                kept.add(found);
                return found;
            }
        }
        if (kept.size() == KEPT) {
            kept.remove(0);
        }
        Groundwork made = new Groundwork(scene, actor);
        kept.add(made);
        return made;
    }
}
