package troupe.unified.search;

import java.util.Optional;
import troupe.search.Expander;
import troupe.search.LabelPool;
import troupe.unified.cost.CostToGo;

/**
 * Holds the label that a search waits for, and what it waits for: that the backward search answers, or that a
 * manipulation instance has had its turn. Used by one thread at a time.
 */
final class Awaited {
    private int label = LabelPool.NONE;
    private long key;
    private CostToGo asked;
    private Turn turn;
    private Optional<Enclosure> enclosure = Optional.empty();

    /** Waits for the answer of a backward search that has been asked for something. */
    Expander.Verdict answer(CostToGo of, int waiting, long waitingKey) {
        asked = of;
        return wait(waiting, waitingKey);
    }

    /** Waits for an instance to have its turn; {@code leadsOutOf} is what it may lead out of. */
    Expander.Verdict turn(Turn next, Optional<Enclosure> leadsOutOf, int waiting, long waitingKey) {
        turn = next;
        enclosure = leadsOutOf;
        return wait(waiting, waitingKey);
    }

    private Expander.Verdict wait(int waiting, long waitingKey) {
        label = waiting;
        key = waitingKey;
        return Expander.Verdict.WAITING;
    }

    /** Tells whether something is waited for. */
    boolean isThere() {
        return asked != null || turn != null;
    }

    /** Tells whether an instance has its turn. */
    boolean isTurn() {
        return turn != null;
    }

    /** Works on what is waited for with at most {@code budget} expansions; returns those made. */
    long advance(long budget) {
        return turn != null ? turn.advance(budget) : asked.advance(budget);
    }

    /** Tells whether what was waited for is there; then nothing is waited for any more. */
    boolean end() {
        boolean over = turn != null ? turn.isOver() : asked.hasAnswered();
        if (over) {
            turn = null;
            asked = null;
        }
        return over;
    }

    /** Returns the label that waits, or waited last. */
    int label() {
        return label;
    }

    /** Returns the key that it had when it came first. */
    long key() {
        return key;
    }

    /** Returns what the instance that had its turn last may lead out of. */
    Optional<Enclosure> enclosure() {
        return enclosure;
    }
}
