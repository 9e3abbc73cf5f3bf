package troupe.app.plan;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import troupe.run.Run;
import troupe.run.Simulation;

/**
 * Follows a simulation that has ended with a second engine, which stands at the moment shown, so that whoever steers
 * there need not wait until everything before has been simulated again. Engines hand out no copies of their state: it
 * lies in many parts, and a second engine makes the same frames. It works on a thread of its own, half of the time at
 * most, which ends when there is nothing to follow. Safe for any thread.
 */
final class Understudy {
    private static final long SLICE_NANOS = TimeUnit.MILLISECONDS.toNanos(4);
    private static final long IDLE_SECONDS = 2;

    private final Supplier<Simulation> fresh;
    private final ThreadPoolExecutor worker;
    private final AtomicReference<Place> asked = new AtomicReference<>();
    private final AtomicBoolean busy = new AtomicBoolean();
    /** What has been gone to last, or given up; null if nothing was asked for then. */
    private volatile Place served;

    private Simulation engine;
    private List<Run.Input> inputs = List.of();

    /** Where to go: a step of the run that was given all inputs. */
    private record Place(long step, List<Run.Input> inputs) {}

    /** Makes an understudy of the engines that {@code fresh} starts. */
    Understudy(Supplier<Simulation> fresh) {
        this.fresh = fresh;
        this.worker =
                new ThreadPoolExecutor(1, 1, IDLE_SECONDS, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
                    Thread thread = new Thread(task, "understudy");
                    thread.setDaemon(true);
                    return thread;
                });
        worker.allowCoreThreadTimeOut(true);
    }

    /**
     * Goes to a step of the run that was given {@code all} inputs; the newest call wins. Returns at once, whatever the
     * engine is doing, for it is called where the moment is shown.
     */
    void follow(long step, List<Run.Input> all) {
        asked.set(new Place(step, all));
        if (busy.compareAndSet(false, true)) {
            worker.execute(this::work);
        }
    }

    private void work() {
        do {
            long begin = System.nanoTime();
            while (advance()) {
                LockSupport.parkNanos(System.nanoTime() - begin);
                begin = System.nanoTime();
            }
            busy.set(false);
            // what was asked for after the last look and before this is not left undone
        } while (asked.get() != served && busy.compareAndSet(false, true));
    }

    /** Steps for a moment, and tells whether there is more to do. */
    private synchronized boolean advance() {
        Place place = asked.get();
        if (place == null) {
            served = null;
            return false;
        }
        if (!place.inputs().equals(inputs)) {
            engine = null;
            inputs = place.inputs();
        }
        if (engine == null || engine.progress().work() > place.step()) {
            engine = fresh.get();
        }
        long begin = System.nanoTime();
        while (engine.progress().work() < place.step()
                && engine.outcome().isRunning()
                && System.nanoTime() - begin < SLICE_NANOS) {
            long now = engine.progress().work();
            inputs.stream().filter(input -> input.step() == now).forEach(engine::give);
            engine.step(1);
        }
        boolean more =
                engine.progress().work() < place.step() && engine.outcome().isRunning();
        if (!more) {
            served = place;
        }
        return more;
    }

    /**
     * Returns the engine if it stands at a step or before it and was given just those of {@code kept} that belong to the
     * steps that it has done. What it was to follow is over; it begins anew with the next {@link #follow}. Waits for a
     * moment's work at most.
     */
    synchronized Optional<Simulation> take(long step, List<Run.Input> kept) {
        Simulation one = engine;
        engine = null;
        asked.set(null);
        return Optional.ofNullable(one)
                .filter(e -> e.outcome().isRunning() && e.progress().work() <= step)
                .filter(e -> e.run().inputs().equals(before(e.progress().work(), kept)));
    }

    private static List<Run.Input> before(long step, List<Run.Input> all) {
        return all.stream().filter(input -> input.step() < step).toList();
    }
}
