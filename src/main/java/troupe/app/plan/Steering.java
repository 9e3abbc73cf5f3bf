package troupe.app.plan;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongConsumer;

/**
 * Holds what a person wants of a simulation: a step to go back to, values to set, and how far it may run ahead
 * while something is held. The event thread asks, the simulating thread takes. Safe for any thread; nothing here
 * takes long.
 */
final class Steering {
    /** No step: go nowhere back, run ahead as far as there is. */
    static final long NONE = Long.MAX_VALUE;

    /** Steps that a simulation may be ahead of what is shown while something is held. */
    static final long LEAD = 3;

    private static final long MOVING_NANOS = TimeUnit.MILLISECONDS.toNanos(150);

    private final LongConsumer paced;
    private final Map<String, Double> wanted = new LinkedHashMap<>();
    private long back = NONE;
    private long limit = NONE;
    private long shown;
    private long movedAt = System.nanoTime() - MOVING_NANOS;

    /** What was asked for since the last time: the step to go back to, or {@link #NONE}, and the values to set then. */
    record Orders(long back, Map<String, Double> values) {}

    /** Makes what a person wants; {@code paced} is told each step that is shown, on the thread that tells it. */
    Steering(LongConsumer paced) {
        this.paced = paced;
    }

    /** Takes hold at a step: what was simulated from it on is dropped, and the simulation stays near what is shown. */
    synchronized void grab(long step) {
        back = Math.min(back, step);
        limit = step + LEAD;
        notifyAll();
    }

    /** Sets a value from the next step on. */
    synchronized void set(String key, double value) {
        wanted.put(key, value);
        notifyAll();
    }

    /** Takes the step that is shown, which the simulation follows while something is held. */
    void pace(long step) {
        show(step);
        paced.accept(step);
    }

    private synchronized void show(long step) {
        if (step != shown) {
            shown = step;
            movedAt = System.nanoTime();
        }
        if (limit != NONE) {
            limit = Math.max(limit, step + LEAD);
            notifyAll();
        }
    }

    /** Tells whether a simulation at {@code step} is more than {@code steps} ahead of what is shown. */
    synchronized boolean isFarAhead(long step, long steps) {
        return limit == NONE && step - shown > steps;
    }

    /** Tells whether what is shown has moved on just now. */
    synchronized boolean isPlayed() {
        return System.nanoTime() - movedAt < MOVING_NANOS;
    }

    /** Waits until something is asked for, {@code millis} at most. */
    synchronized void rest(long millis) throws InterruptedException {
        if (isIdle()) {
            wait(millis);
        }
    }

    /** Lets go: the simulation may run ahead as far as there is. */
    synchronized void release() {
        limit = NONE;
        notifyAll();
    }

    /** Takes what was asked for since the last time. */
    synchronized Orders take() {
        Orders orders = new Orders(back, new LinkedHashMap<>(wanted));
        back = NONE;
        wanted.clear();
        return orders;
    }

    /** Returns the step that the simulation may not pass now. */
    synchronized long limit() {
        return limit;
    }

    /** Tells whether something was asked for that has not been taken. */
    synchronized boolean isAsked() {
        return back != NONE || !wanted.isEmpty();
    }

    /** Tells whether nothing is held and nothing asked for. */
    synchronized boolean isIdle() {
        return limit == NONE && back == NONE && wanted.isEmpty();
    }

    /** Waits until something is asked for or the limit passes {@code step}, {@code millis} at most. */
    synchronized void await(long step, long millis) throws InterruptedException {
        if (back == NONE && wanted.isEmpty() && limit != NONE && limit <= step) {
            wait(millis);
        }
    }
}
