package troupe.work.batch;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;

/** Does pieces of work on several threads and hands the results over in the order of the pieces. */
final class Ordered {
    private Ordered() {}

    /**
     * Does the pieces on {@code jobs} threads; at most twice as many are begun ahead of the one whose result
     * is wanted next. {@code taker} gets the results on the calling thread; it ends the work by
     * returning false. When {@code cancelled} says so no further piece is begun.
     */
    static <T> void run(List<Callable<T>> pieces, int jobs, BooleanSupplier cancelled, Predicate<T> taker) {
        ExecutorService pool = Executors.newFixedThreadPool(jobs);
        try {
            Deque<Future<T>> waiting = new ArrayDeque<>();
            int next = 0;
            boolean more = true;
            while (more) {
                while (next < pieces.size() && waiting.size() < 2 * jobs && !cancelled.getAsBoolean()) {
                    waiting.add(pool.submit(pieces.get(next++)));
                }
                more = !waiting.isEmpty() && taker.test(taken(waiting.remove()));
            }
        } finally {
            pool.shutdownNow();
        }
    }

    private static <T> T taken(Future<T> future) {
        try {
            return future.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while waiting for a piece of work", e);
        } catch (ExecutionException e) {
            throw new IllegalStateException("a piece of work failed: " + e.getCause(), e.getCause());
        }
    }
}
