package troupe.unified.search;

import java.util.List;
import java.util.Optional;
import troupe.grid.region.Reach;
import troupe.search.Outcome;

/**
 * Holds the configurations of a search space that can be reached from one of them by legal steps, counters
 * ignored. If the goal is not among them, they can be left only by moving something: by one of the manipulation
 * instances that begin there. So whatever is still to be paid includes the least of what those cost, as far as it
 * is not in the bound on the cost to go already.
 */
final class Enclosure {
    private final Reach reach;
    private final boolean open;
    private List<MoveAttempt> exits = List.of();
    private boolean known;
    private long least;

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
        update();
    }

    /** Returns a lower bound in units on what leaving it costs besides the way; {@link Long#MAX_VALUE} if nothing leads out. */
    long least() {
        return least;
    }

    /** Takes notice of what the instances have found out since. */
    void update() {
        if (known) {
            least = Long.MAX_VALUE;
            for (MoveAttempt exit : exits) {
                least = Math.min(least, exit.share());
            }
        }
    }

    /** Returns the instance that decides the bound, if it is still working; empty if the bound cannot rise any more. */
    Optional<MoveAttempt> deciding() {
        MoveAttempt cheapest = null;
        for (MoveAttempt exit : exits) {
            if (cheapest == null || exit.share() < cheapest.share()) {
                cheapest = exit;
            }
        }
        return Optional.ofNullable(cheapest).filter(exit -> exit.outcome() instanceof Outcome.Running);
    }

    /** Returns the least bound of the instances other than one. */
    long leastBut(MoveAttempt attempt) {
        long others = Long.MAX_VALUE;
        for (MoveAttempt exit : exits) {
            if (exit != attempt) {
                others = Math.min(others, exit.share());
            }
        }
        return others;
    }
}
