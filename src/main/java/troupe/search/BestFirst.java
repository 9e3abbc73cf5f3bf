package troupe.search;

/**
 * Drives a best-first search: takes the first open item again and again until the goal is taken, nothing
 * is open, the limit is reached, or it is cancelled. It can stop after any expansion and go on later;
 * how it is sliced changes nothing. Used by one thread at a time; allocates nothing.
 */
public final class BestFirst {
    private final OpenList open;
    private final Expander expander;
    private final Outcome failure;
    private final long limit;
    private Outcome outcome = Outcome.RUNNING;
    private long expanded;
    private boolean waiting;

    /**
     * Makes a search over what {@code open} holds when it is first driven.
     *
     * @param open holds the start already, or will before the first step
     * @param expander adds successors to {@code open}
     * @param failure the outcome when nothing is open any more
     * @param limit the most expansions, at least 1; one more ends in {@code Exhausted}
     */
    public BestFirst(OpenList open, Expander expander, Outcome failure, long limit) {
        if (limit < 1) {
            throw new IllegalArgumentException("limit=" + limit + "; needs at least 1");
        }
        this.open = open;
        this.expander = expander;
        this.failure = failure;
        this.limit = limit;
    }

    /**
     * Expands at most {@code budget} items, fewer if the search ends or an item waits.
     *
     * @param budget at least 1
     */
    public Outcome step(long budget) {
        if (budget < 1) {
            throw new IllegalArgumentException("budget=" + budget + "; needs at least 1");
        }
        waiting = false;
        long end = budget > Long.MAX_VALUE - expanded ? Long.MAX_VALUE : expanded + budget;
        while (outcome.isRunning() && expanded < end && !waiting) {
            if (open.isEmpty()) {
                outcome = failure;
            } else if (expanded >= limit) {
                outcome = Outcome.EXHAUSTED;
            } else {
                take();
            }
        }
        return outcome;
    }

    private void take() {
        long key = open.firstKey();
        switch (expander.expand(open.removeFirst(), key)) {
            case EXPANDED -> expanded++;
            case GOAL -> {
                expanded++;
                outcome = Outcome.FOUND;
            }
            case WAITING -> waiting = true;
            case SKIPPED -> {
                // the next item may do
            }
        }
    }

    /** Returns how the search stands. */
    public Outcome outcome() {
        return outcome;
    }

    /** Tells whether the last step ended because an item waits for something outside of the loop. */
    public boolean isWaiting() {
        return waiting;
    }

    /** Returns the expansions so far. */
    public long expanded() {
        return expanded;
    }

    /** Counts work that was done outside of the loop, while an item waited, like {@code expansions} made here. */
    public void charge(long expansions) {
        expanded += expansions;
    }

    /** Ends the search with the outcome {@code Exhausted}, because something else than expansions has come to its limit. */
    public void exhaust() {
        if (outcome.isRunning()) {
            outcome = Outcome.EXHAUSTED;
        }
    }

    /** Ends the search with the outcome {@code Cancelled}, unless it has ended already. */
    public void cancel() {
        if (outcome.isRunning()) {
            outcome = Outcome.CANCELLED;
        }
    }
}
