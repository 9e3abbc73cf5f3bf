package troupe.unified.search;

import troupe.unified.manipulation.Instance;

/**
 * Holds what a search buys of a manipulation instance at a time: at most a slice of expansions, and none once
 * its least cost passes what is worth it now. Both are fixed when the turn begins, so that it does not matter in
 * how many pieces it is taken.
 */
final class Turn {
    private final MoveAttempt attempt;
    private final long most;
    private long left;

    /**
     * Begins a turn, in which at least one expansion is done if the instance still has one to do.
     *
     * @param slice the most expansions, at least 1
     * @param most the greatest least cost in units of the instance's queue with which it is gone on with; {@link
     *     Long#MAX_VALUE} if any
     */
    Turn(MoveAttempt attempt, long slice, long most) {
        this.attempt = attempt;
        this.left = slice;
        this.most = Math.max(most, attempt.instance().least());
        attempt.countTurn();
    }

    /** Does at most {@code budget} expansions, from 0; returns those done. */
    long advance(long budget) {
        long done = attempt.instance().advance(Math.min(budget, left), most);
        left -= done;
        return done;
    }

    /** Tells whether nothing is left to be done in it. */
    boolean isOver() {
        Instance instance = attempt.instance();
        return !instance.outcome().isRunning() || left == 0 || instance.least() > most;
    }
}
