package troupe.app.play;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import troupe.run.Run;

/** Makes the chronicles of runs on a background thread; the newest request wins. */
public final class Chronicles implements AutoCloseable {
    private final Executor eventThread;
    private final Consumer<Optional<Chronicle>> taker;
    private final AtomicLong newest = new AtomicLong();
    private final ExecutorService worker = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "chronicles");
        thread.setDaemon(true);
        return thread;
    });

    /** Makes a maker of chronicles; {@code taker} gets them on the event thread. */
    public Chronicles(Executor eventThread, Consumer<Optional<Chronicle>> taker) {
        this.eventThread = eventThread;
        this.taker = taker;
    }

    /** Asks for the chronicle of a run whose steps took so many milliseconds each. */
    public void request(Run run, double[] stepMillis) {
        long request = newest.incrementAndGet();
        worker.execute(() -> {
            if (request == newest.get()) {
                Optional<Chronicle> made = Chronicle.of(run, stepMillis);
                eventThread.execute(() -> taker.accept(made));
            }
        });
    }

    /** Ends the background thread. */
    @Override
    public void close() {
        worker.shutdown();
    }
}
