package troupe.app.export;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import troupe.app.look.Failures;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.run.Run;

/** Makes previews and files on a background thread; of several previews only the newest is made. */
final class ExportWork implements AutoCloseable {
    private final Executor eventThread;
    private final ExecutorService worker = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "export");
        thread.setDaemon(true);
        return thread;
    });
    private final AtomicInteger newest = new AtomicInteger();
    private AtomicBoolean stop = new AtomicBoolean();

    /** How an export ended: a message where it failed, nothing where it was cancelled or is done. */
    record Result(boolean done, Optional<String> wrong) {}

    ExportWork(Executor eventThread) {
        this.eventThread = eventThread;
    }

    /** Makes a preview; {@code taker} gets it on the event thread if no other has been asked for. */
    void preview(Exporter exporter, Run run, ExportSettings settings, Consumer<Preview> taker) {
        int wish = newest.incrementAndGet();
        worker.execute(() -> {
            if (wish == newest.get()) {
                Preview preview = Preview.of(exporter, run, settings.until(() -> wish != newest.get()));
                eventThread.execute(() -> {
                    if (wish == newest.get()) {
                        taker.accept(preview);
                    }
                });
            }
        });
    }

    /**
     * Writes a file.
     *
     * @param pictures is told on the event thread how many pictures have been begun
     * @param ended is told on the event thread how it ended
     */
    void write(
            Exporter exporter,
            Run run,
            ExportSettings settings,
            Path target,
            Consumer<Integer> pictures,
            Consumer<Result> ended) {
        AtomicBoolean stopped = new AtomicBoolean();
        stop = stopped;
        newest.incrementAndGet();
        AtomicInteger begun = new AtomicInteger();
        ExportSettings watched = settings.until(() -> {
            int count = begun.incrementAndGet();
            eventThread.execute(() -> pictures.accept(count));
            return stopped.get();
        });
        worker.execute(() -> {
            Result result = result(exporter, run, watched, target);
            eventThread.execute(() -> ended.accept(result));
        });
    }

    private static Result result(Exporter exporter, Run run, ExportSettings settings, Path target) {
        try {
            exporter.write(run, settings, target);
            return new Result(true, Optional.empty());
        } catch (InterruptedIOException e) {
            return new Result(false, Optional.empty());
        } catch (IOException | ExchangeException e) {
            return new Result(false, Optional.of(Failures.line(target, e)));
        }
    }

    /** Ends the export under way; nothing of it is left. */
    void cancel() {
        stop.set(true);
    }

    @Override
    public void close() {
        cancel();
        newest.incrementAndGet();
        worker.shutdown();
    }
}
