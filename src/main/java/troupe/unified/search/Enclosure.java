package troupe.unified.search;

import java.util.List;
import java.util.Optional;
import troupe.grid.region.Reach;
import troupe.unified.cost.Priority;

/**
 * Holds the configurations of a search space that can be reached from one of them by legal steps, counters
 * ignored; where the goal is among them, maybe only some of them. If the goal is not among them, they can be left only by moving something: by one of the manipulation
 * instances that begin there, its exits.
 */
final class Enclosure {
    private final Reach reach;
    private final boolean open;
    private List<MoveAttempt> exits = List.of();
    private boolean known;
    private long least;
    private long others;
    private Optional<MoveAttempt> deciding = Optional.empty();
    private Optional<Priority.Bound> toExit = Optional.empty();

    /** Makes the enclosure that {@code reach} holds; it is open if the goal is in it. */
    Enclosure(Reach reach, int goal) {
        this.reach = reach;
        this.open = reach.reached(goal);
    }

    /** Tells whether a configuration is in it. */
    boolean holds(int configuration) {
        return reach.reached(configuration);
    }

    /** Tells whether it needs no exit, or it is known which there are. */
    boolean isKnown() {
        return open || known;
    }

    /** Says which instances begin in it. */
    void setExits(List<MoveAttempt> attempts) {
        exits = List.copyOf(attempts);
        known = true;
    }

    List<MoveAttempt> exits() {
        return exits;
    }

    /**
     * Says what its exits cost.
     *
     * @param least a lower bound in units on what leaving costs besides the way; {@link Long#MAX_VALUE} if nothing
     *     leads out
     * @param others the same of all exits but the cheapest
     * @param deciding the cheapest, if its bound can still rise
     */
    void setLeast(long least, long others, Optional<MoveAttempt> deciding) {
        this.least = least;
        this.others = others;
        this.deciding = deciding;
    }

    /** Returns a lower bound in units on what leaving costs besides the way, 0 if the goal is inside. */
    long least() {
        return least;
    }

    /** Returns the same of all exits but the cheapest. */
    long others() {
        return others;
    }

    /** Returns the exit that decides the bound, if it is still working; empty if the bound is as high as it gets. */
    Optional<MoveAttempt> deciding() {
        return deciding;
    }

    /** Tells whether the goal is in it. */
    boolean isOpen() {
        return open;
    }

    /** Says what the ways to the exits cost, with what leaving by each costs at least, and the way from there. */
    void setToExit(Priority.Bound ways) {
        toExit = Optional.of(ways);
    }

    /** Returns what the ways to the exits cost, over configurations of the space; empty if that is not known yet. */
    Optional<Priority.Bound> toExit() {
        return toExit;
    }
}
