package troupe.crowd.flock;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.RecursiveAction;

/**
 * Runs a piece of work over the numbers from 0 to n, in chunks, on one thread or on those of a fork-join pool. What
 * a chunk writes must belong to its own numbers, so that the result does not depend on the threads.
 */
public final class Sweep {
    /** The most numbers of a chunk of heavy work, and of light work. */
    private static final int HEAVY = 128;

    private static final int LIGHT = 2048;

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

    /** Does work that sweeps many times, so that its threads are woken once. */
    public void whole(Runnable work) {
        if (pool == null || ForkJoinTask.getPool() == pool) {
            work.run();
        } else {
            pool.invoke(ForkJoinTask.adapt(work));
        }
    }

    /** Works over {@code [0, n)} and returns when all is done. */
    public void over(int n, Range work) {
        spread(n, HEAVY, work);
    }

    /** Works over {@code [0, n)} in large chunks, for work of a few nanoseconds for each number. */
    void lightly(int n, Range work) {
        spread(n, LIGHT, work);
    }

    private void spread(int n, int chunk, Range work) {
        if (pool == null || n <= chunk) {
            work.run(0, n);
            return;
        }
        Part part = new Part(0, n, chunk, work);
        if (ForkJoinTask.getPool() == pool) {
            part.invoke();
        } else {
            pool.invoke(part);
        }
    }

    /** A part of the numbers; halved until it is a chunk. */
    private static final class Part extends RecursiveAction {
        private static final long serialVersionUID = 1;
        private final int from;
        private final int to;
        private final int chunk;
        private final transient Range work;

        Part(int from, int to, int chunk, Range work) {
            this.from = from;
            this.to = to;
            this.chunk = chunk;
            this.work = work;
        }

        @Override
        protected void compute() {
            if (to - from <= chunk) {
                work.run(from, to);
                return;
            }
            int middle = from + ((to - from) / chunk + 1) / 2 * chunk;
            invokeAll(new Part(from, middle, chunk, work), new Part(middle, to, chunk, work));
        }
    }
}
