package troupe.unified.search;

import troupe.search.Outcome;
import troupe.unified.manipulation.ConfigurationSpace;
import troupe.unified.manipulation.ExpectedPath;
import troupe.unified.manipulation.Instance;
import troupe.unified.obstacle.Movable;

/** Holds one manipulation instance of a search: what it moves in which space, from where, and how it stands. */
public final class MoveAttempt {
    private final SearchSpace space;
    private final int movable;
    private final Movable obstacle;
    private final int trigger;
    private final ExpectedPath path;
    private final ConfigurationSpace barred;
    private final Instance instance;
    private long turns;

    MoveAttempt(
            SearchSpace space,
            int movable,
            Movable obstacle,
            int trigger,
            ExpectedPath path,
            ConfigurationSpace barred,
            Instance instance) {
        this.space = space;
        this.movable = movable;
        this.obstacle = obstacle;
        this.trigger = trigger;
        this.path = path;
        this.barred = barred;
        this.instance = instance;
    }

    /** Returns the search space in which the obstacle is to be moved. */
    SearchSpace space() {
        return space;
    }

    /** Returns the place of the obstacle in the list of movables. */
    int movable() {
        return movable;
    }

    /** Returns the obstacle. */
    public Movable obstacle() {
        return obstacle;
    }

    /** Returns the trigger point from which the expected path leads, a configuration of the space. */
    public int trigger() {
        return trigger;
    }

    /** Returns the expected path. */
    public ExpectedPath path() {
        return path;
    }

    /** Returns the configuration space of the obstacle: the poses in which it bars the expected path. */
    public ConfigurationSpace barred() {
        return barred;
    }

    Instance instance() {
        return instance;
    }

    /**
     * Returns a lower bound in units on what the instance adds to the bound on the cost to go: the obstacle's part
     * of the least cost in its queue; {@link Long#MAX_VALUE} if it has failed.
     */
    long share() {
        long least = instance.least();
        return least == Long.MAX_VALUE ? least : (long) (instance.obstacleShare() * least);
    }

    /** Returns the least cost in its queue at which {@link #share} is {@code share}. */
    long leastOf(long share) {
        return share == Long.MAX_VALUE ? share : (long) (share / instance.obstacleShare());
    }

    /** Returns how the instance stands. */
    public Outcome outcome() {
        return instance.outcome();
    }

    /** Returns the poses that the instance has expanded. */
    public long expanded() {
        return instance.expanded();
    }

    void countTurn() {
        turns++;
    }

    /** Returns how many turns of the search it has got. */
    public long turns() {
        return turns;
    }
}
