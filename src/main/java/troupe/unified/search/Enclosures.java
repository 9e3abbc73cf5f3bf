package troupe.unified.search;

import java.util.List;
import java.util.Optional;
import troupe.unified.manipulation.Instance;
import troupe.unified.manipulation.Transfer;

/**
 * Knows what has to be paid at least, besides the bound on the cost to go, where the goal is out of reach in a search
 * space: something must be moved then. A label in such a place waits until it is known which manipulation
 * instances begin there, and until the one that promises to cost least has found a place for its obstacle. After
 * that the search follows the way to it, instead of looking everywhere for what the bound did not know of.
 */
final class Enclosures {
    private final Manipulations manipulations;
    private final CostToGo toGo;
    private final int goal;

    Enclosures(Manipulations manipulations, CostToGo toGo, int goal) {
        this.manipulations = manipulations;
        this.toGo = toGo;
        this.goal = goal;
    }

    /** Returns the enclosure of a configuration. */
    Enclosure of(SearchSpace space, int configuration) {
        return space.enclosure(configuration, goal);
    }

    /**
     * Returns what has to be paid at least besides the bound on the cost to go from a configuration: 0 where that
     * is not known yet, {@link Long#MAX_VALUE} if nothing leads out.
     */
    long least(SearchSpace space, int configuration) {
        return space.enclosure(configuration).map(Enclosure::least).orElse(0L);
    }

    /**
     * Tells whether it is known which instances begin in an enclosure; else {@link CostToGo} has been asked for what
     * that takes.
     */
    boolean isKnown(SearchSpace space, Enclosure enclosure) {
        if (!enclosure.isKnown()) {
            toGo.wantExact(manipulations.wanted(space, enclosure));
            if (!toGo.isExact()) {
                return false;
            }
            enclosure.setExits(manipulations.exits(space, enclosure));
            update(enclosure);
        }
        return true;
    }

    /** Returns the exit that decides what leaving costs at least, if that can still rise. */
    Optional<MoveAttempt> deciding(Enclosure enclosure) {
        if (enclosure.deciding().filter(exit -> !exit.outcome().isRunning()).isPresent()) {
            update(enclosure);
        }
        return enclosure.deciding();
    }

    /** Takes notice of what the instances of an enclosure have found out since. */
    void update(Enclosure enclosure) {
        List<MoveAttempt> exits = enclosure.exits();
        long least = Long.MAX_VALUE;
        long others = Long.MAX_VALUE;
        MoveAttempt cheapest = null;
        for (MoveAttempt exit : exits) {
            long gap = gap(exit);
            if (cheapest == null || gap < least) {
                others = least;
                least = gap;
                cheapest = exit;
            } else {
                others = Math.min(others, gap);
            }
        }
        boolean rises = cheapest != null && cheapest.outcome().isRunning();
        enclosure.setLeast(least, others, rises ? Optional.of(cheapest) : Optional.empty());
    }

    /**
     * Returns a lower bound in units on what going on by an instance costs more than the bound on the cost to go from
     * its trigger point says: the obstacle's part of the least cost, and when it is known where the actor lets
     * go, the whole cost and what the bound changes by.
     */
    long gap(MoveAttempt exit) {
        long share = exit.share();
        if (!exit.outcome().isFound()) {
            return share;
        }
        Instance instance = exit.instance();
        Transfer transfer = instance.transfer();
        if (!transfer.gripped()) {
            return instance.cost();
        }
        long change = toGo.bound(transfer.to()) - toGo.bound(exit.trigger());
        return Math.max(share, instance.cost() + change);
    }
}
