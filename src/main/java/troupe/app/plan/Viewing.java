package troupe.app.plan;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import troupe.run.Engine;
import troupe.run.Simulation;
import troupe.run.view.Overlay;

/**
 * Makes the views of plans on a thread of its own, so that no plan waits for those of the one before. An engine is
 * handed over when it has ended, so that it is still used by one thread at a time; a simulation, which can go on after
 * its end, stays with the thread that works it.
 */
final class Viewing implements AutoCloseable {
    /** How long in ms there is at least between the beginnings of the views of two moments of gestures. */
    static final long REST_MS = 100;

    private final PlanningSteps steps;
    private final Announcer announcer;
    private final Worker planning;
    private final Worker viewing;
    private volatile List<Integer> chosen = List.of();
    private volatile Set<String> shown = Set.of();
    private final AtomicReference<Waiting> waiting = new AtomicReference<>();
    private volatile Made seen;
    private volatile long begun = System.nanoTime() - TimeUnit.MILLISECONDS.toNanos(REST_MS);

    /** An engine that has ended, and which choice its views are of. */
    private record Made(Watch watch, Engine engine, List<Integer> of) {}

    /** An engine that has ended and waits for its views, and what follows them. */
    private record Waiting(Watch watch, Engine engine, Runnable then) {}

    /** Makes views of nothing yet; what follows the views goes on in {@code planning}. */
    Viewing(PlanningSteps steps, Announcer announcer, Worker planning, Executor eventThread) {
        this.steps = steps;
        this.announcer = announcer;
        this.planning = planning;
        this.viewing = new Worker("views", eventThread);
    }

    /** Says which views moments of a gesture need. */
    void show(Set<String> keys) {
        shown = Set.copyOf(keys);
    }

    /** Makes the views of a plan, unless a newer one comes before they are begun, and goes on with what follows. */
    void view(Watch watch, Engine engine, Runnable then) {
        waiting.set(new Waiting(watch, engine, then));
        long rest = begun + TimeUnit.MILLISECONDS.toNanos(REST_MS) - System.nanoTime();
        if (!watch.isMoment() || rest <= 0) {
            viewing.submit(watch, () -> viewIfNewest(watch));
        } else {
            CompletableFuture.delayedExecutor(rest, TimeUnit.NANOSECONDS)
                    .execute(() -> viewing.submit(watch, () -> viewIfNewest(watch)));
        }
    }

    private void viewIfNewest(Watch watch) {
        Waiting next = waiting.get();
        if (next == null || next.watch() != watch || !waiting.compareAndSet(next, null)) {
            return;
        }
        if (watch.isUnwanted()) {
            announcer.idle(watch.snapshot());
            return;
        }
        begun = System.nanoTime();
        try {
            make(watch, next.engine());
            planning.submit(watch, next.then());
        } catch (CancellationException e) {
            announcer.idle(watch.snapshot()); // not wanted any more: what was told before stays
        }
    }

    /** Makes the views of a simulation that has ended for now, on the thread that works it. */
    void viewHere(Watch watch, Simulation engine) {
        if (watch.isWanted()) {
            make(watch, engine);
        }
    }

    private Views made(Watch watch, Engine engine) {
        List<Integer> of = chosen;
        Set<String> needed = shown;
        Predicate<String> wanted = watch.isMoment() ? needed::contains : key -> true;
        Snapshot snapshot = watch.snapshot();
        List<Overlay> overlays = steps.overlays(snapshot.scene(), snapshot.task(), engine, of, wanted);
        seen = new Made(watch, engine, of);
        return watch.isMoment()
                ? Views.some(snapshot.scene(), overlays, engine.aspects(of))
                : Views.of(snapshot.scene(), overlays, engine.aspects(of));
    }

    private void make(Watch watch, Engine engine) {
        Views views = made(watch, engine);
        if (!watch.isCancelled()) {
            watch.tellViews(views);
        }
    }

    /** Makes the views of another choice. */
    void look(List<Integer> choices) {
        chosen = List.copyOf(choices);
        Made last = seen;
        if (last != null) {
            Worker worker = last.engine() instanceof Simulation ? planning : viewing;
            worker.submit(last.watch(), this::lookAgain);
        }
    }

    private void lookAgain() {
        Made last = seen;
        if (last != null && !last.of().equals(chosen) && last.watch().isNewest()) {
            last.watch().tellViews(made(last.watch(), last.engine()));
        }
    }

    /** Lets a watch take over what was told last of the same snapshot; tells whether there was something. */
    boolean goesOn(Watch watch) {
        Made last = seen;
        if (last != null && last.watch().snapshot() == watch.snapshot()) {
            watch.goOnFrom(last.watch().latest());
        }
        return watch.latest() != null;
    }

    /** Sees to it that views that are not wanted any more are not waited for. */
    void hurry() {
        viewing.hurry();
    }

    @Override
    public void close() {
        seen = null;
        waiting.set(null);
        viewing.close();
    }
}
