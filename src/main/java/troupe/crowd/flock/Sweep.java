package troupe.crowd.flock;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveAction;

/**
 * Runs a piece of work over the numbers from 0 to n, in chunks, on one thread or on those of a fork-join pool. What
 * a chunk writes must belong to its own numbers, so that the result does not depend on the threads.
 */
public final class Sweep {
    private static final int CHUNK = 256;

    /** Works over {@code [from, to)}. */
    @FunctionalInterface
    public interface Range {
        void run(int from, int to);
    }

    private final ForkJoinPool pool;

    private Sweep(ForkJoinPool pool) {
        this.pool = pool;
    }

    /** Returns a sweep on the calling thread alone. */
    public static Sweep alone() {
        return new Sweep(null);
    }

    /** Returns a sweep on the threads of a pool. */
    public static Sweep on(ForkJoinPool pool) {
        return new Sweep(pool);
    }

    /** Works over {@code [0, n)} and returns when all is done. */
    public void over(int n, Range work) {
        if (pool == null || n <= CHUNK) {
            for (int from = 0; from < n; from += CHUNK) {
                work.run(from, Math.min(n, from + CHUNK));
            }
            return;
        }
        pool.invoke(new Part(0, n, work));
    }

    /** A part of the numbers; halved until it is a chunk. */
    private static final class Part extends RecursiveAction {
        private static final long serialVersionUID = 1;
        private final int from;
        private final int to;
        private final transient Range work;

        Part(int from, int to, Range work) {
            this.from = from;
            this.to = to;
            this.work = work;
        }

        @Override
        protected void compute() {
            if (to - from <= CHUNK) {
                work.run(from, to);
                return;
            }
            int middle = from + ((to - from) / CHUNK + 1) / 2 * CHUNK;
            invokeAll(new Part(from, middle, work), new Part(middle, to, work));
        }
    }
}
