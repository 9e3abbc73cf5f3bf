package troupe.unified.search;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.unified.cost.CostToGo;
import troupe.unified.cost.FieldMemory;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.Priority;
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
    private final JourneyCosts costs;
    private final double weight;
    private final int goal;
    private final List<CostToGo> ways = new ArrayList<>();

    /** Makes what knows of no enclosure yet; {@code weight} is that of the keys. */
    Enclosures(Manipulations manipulations, CostToGo toGo, JourneyCosts costs, double weight, int goal) {
        this.manipulations = manipulations;
        this.toGo = toGo;
        this.costs = costs;
        this.weight = weight;
        this.goal = goal;
    }

    /** Returns the enclosure of a configuration. */
    Enclosure of(SearchSpace space, int configuration) {
        return space.enclosure(configuration, goal);
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

    /**
     * Begins to look for the ways to the exits, if there are any: a backward search over the space from all trigger
     * points, each at what going on from it costs at least as is known now. What the exits cost may turn out to be more
     * later; so it stays a lower bound.
     *
     * @param towards where the ways are asked for first
     */
    void lead(SearchSpace space, Enclosure enclosure, int towards) {
        List<Long> places = new ArrayList<>();
        List<Long> least = new ArrayList<>();
        manipulations.eachExit(space, enclosure, (point, attempt) -> {
            long gap = gap(attempt);
            if (gap < Long.MAX_VALUE) {
                places.add((long) point);
                least.add(gap + toGo.bound(point));
            }
        });
        CostToGo.Ends ends = new CostToGo.Ends(
                places.stream().mapToInt(Long::intValue).toArray(),
                least.stream().mapToLong(Long::longValue).toArray());
        CostToGo toExit = new CostToGo(new FieldMemory(space.region(), false), costs, towards, ends);
        ways.add(toExit);
        enclosure.setToExit(new Priority.Bound(toExit, weight));
    }

    /** Returns the expansions made so far to find the ways to exits. */
    long expanded() {
        return ways.stream().mapToLong(CostToGo::expanded).sum();
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
