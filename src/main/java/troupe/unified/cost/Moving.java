package troupe.unified.cost;

import java.util.List;
import java.util.Optional;
import troupe.grid.region.Region;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.unified.obstacle.Movable;

/**
 * Says what a search may move, and how.
 *
 * @param scene the scene as it stands
 * @param movables the obstacles that may be moved, ascending by number; none if nothing may
 * @param manipulation whether the actor's body takes part
 * @param slice the most expansions that one turn of the search buys an instance, at least 1
 * @param spaces the most search spaces before the search gives up, at least 1
 * @param guide the region of the {@code paper} ordering's potentials, without any movable obstacle; empty if
 *     it is that of the search. The other orderings do not ask it
 * @param potential the potential over {@code guide} that expected paths descend in the {@code paper} ordering
 */
public record Moving(
        Optional<Scene> scene,
        List<Movable> movables,
        Journey.Manipulation manipulation,
        int slice,
        int spaces,
        Optional<Region> guide,
        JourneyQuery.Potential potential) {

    /** Nothing may be moved. */
    public static final Moving NOTHING = new Moving(
            Optional.empty(),
            List.of(),
            Journey.Manipulation.FREE,
            Journey.DEFAULT_SLICE,
            Journey.DEFAULT_SPACES,
            Optional.empty(),
            JourneyQuery.Potential.NONE);

    /**
     * Copies the list.
     *
     * @throws IllegalArgumentException if the slice or the limit of spaces is below 1, or something may be moved and there is no scene
     */
    public Moving {
        movables = List.copyOf(movables);
        if (slice < 1) {
            throw new IllegalArgumentException("slice=" + slice + "; needs at least 1");
        }
        if (spaces < 1) {
            throw new IllegalArgumentException("limit.spaces=" + spaces + "; needs at least 1");
        }
        if (scene.isEmpty() && !movables.isEmpty()) {
            throw new IllegalArgumentException(movables.size() + " movable obstacles without a scene");
        }
    }

    /** Tells whether anything may be moved. */
    public boolean isPossible() {
        return !movables.isEmpty();
    }

    /** Tells whether the actor holds what it moves. */
    public boolean grips() {
        return manipulation == Journey.Manipulation.GRIP;
    }
}
