package troupe.app.play;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import troupe.run.Run;
import troupe.run.view.Strip;
import troupe.work.view.MomentViews;

/**
 * Works out on a background thread whom the plan of the moment shown may meet; the newest request wins, so that
 * nobody waits while a run is played.
 */
public final class Foresight implements AutoCloseable {
    private final Executor eventThread;
    private final Consumer<Optional<Strip>> taker;
    /** Made by the worker, the only one that uses it. */
    private MomentViews views;

    private final AtomicReference<Moment> newest = new AtomicReference<>();
    private final ExecutorService worker = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "foresight");
        thread.setDaemon(true);
        return thread;
    });

    private record Moment(Run run, double time) {}

    /** Makes a foresight; {@code taker} gets the strips on the event thread. */
    public Foresight(Executor eventThread, Consumer<Optional<Strip>> taker) {
        this.eventThread = eventThread;
        this.taker = taker;
    }

    /** Asks for the strip of a run at a time in seconds. */
    public void request(Run run, double time) {
        if (newest.getAndSet(new Moment(run, time)) == null) {
            worker.execute(this::make);
        }
    }

    private void make() {
        views = views == null ? new MomentViews() : views;
        Moment moment = newest.get();
        while (moment != null) {
            Optional<Strip> made = views.strip(moment.run(), moment.time());
            eventThread.execute(() -> taker.accept(made));
            moment = newest.compareAndSet(moment, null) ? null : newest.get();
        }
    }

    /** Ends the background thread. */
    @Override
    public void close() {
        newest.set(null);
        worker.shutdown();
    }
}
