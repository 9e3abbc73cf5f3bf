package troupe.app.play;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import troupe.run.Run;

/**
 * Makes the chronicles of runs on a background thread; the newest request wins. One that takes long is followed by a
 * rest, so that a run that grows leaves the machine to what simulates and paints it.
 */
public final class Chronicles implements AutoCloseable {
    private static final long LONG_NANOS = TimeUnit.MILLISECONDS.toNanos(4);
    private static final long MOST_REST_NANOS = TimeUnit.SECONDS.toNanos(1);
    /** How many times as long as the work a rest is. */
    private static final int REST = 15;

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
                long begin = System.nanoTime();
                Optional<Chronicle> made = Chronicle.of(run, stepMillis);
                eventThread.execute(() -> taker.accept(made));
                rest(System.nanoTime() - begin);
            }
        });
    }

    private static void rest(long took) {
        if (took > LONG_NANOS) {
            LockSupport.parkNanos(Math.min(REST * took, MOST_REST_NANOS));
        }
    }

    /** Ends the background thread. */
    @Override
    public void close() {
        worker.shutdown();
    }
}
