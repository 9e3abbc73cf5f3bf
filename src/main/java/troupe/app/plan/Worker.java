package troupe.app.plan;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Works on one thing after the other on a thread of its own. Work that is not wanted any more and does not end
 * within {@link LivePlanner#GRACE_MS} is left behind: its thread is interrupted, and another thread takes over what
 * waits. Safe for any thread.
 */
final class Worker implements AutoCloseable {
    /** How many threads may be left behind at a time; more unwanted work is waited for. */
    private static final int LEFT_BEHIND = 3;

    private final String name;
    private final Executor eventThread;
    private ThreadPoolExecutor thread;
    private Job current;
    private int leftBehind;
    private boolean closed;

    /**
     * Makes a worker that does nothing yet.
     *
     * @param name of its threads
     * @param eventThread looks after work that is not wanted any more
     */
    Worker(String name, Executor eventThread) {
        this.name = name;
        this.eventThread = eventThread;
        this.thread = thread();
    }

    private ThreadPoolExecutor thread() {
        return new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
            Thread made = new Thread(task, name);
            made.setDaemon(true);
            return made;
        });
    }

    /** One piece of work for a request. */
    private final class Job implements Runnable {
        private final Watch watch;
        private final Runnable work;

        Job(Watch watch, Runnable work) {
            this.watch = watch;
            this.work = work;
        }

        @Override
        public void run() {
            begin(this);
            try {
                work.run();
            } finally {
                end(this);
            }
        }
    }

    /** Does some work for a request after what waits already; nothing once it is closed. */
    synchronized void submit(Watch watch, Runnable work) {
        if (!closed) {
            thread.execute(new Job(watch, work));
        }
    }

    private synchronized void begin(Job job) {
        current = job;
    }

    private synchronized void end(Job job) {
        if (current == job) {
            current = null;
        } else {
            leftBehind--;
        }
    }

    /** Sees to it that work under way ends soon, or is left behind, if it is not wanted any more. */
    synchronized void hurry() {
        Job job = current;
        if (job != null) {
            CompletableFuture.delayedExecutor(LivePlanner.GRACE_MS, TimeUnit.MILLISECONDS, eventThread)
                    .execute(() -> leave(job));
        }
    }

    private synchronized void leave(Job job) {
        if (closed || current != job || !job.watch.isUnwanted()) {
            return;
        }
        if (leftBehind >= LEFT_BEHIND) {
            hurry();
            return;
        }
        job.watch.leave();
        leftBehind++;
        current = null;
        ThreadPoolExecutor stuck = thread;
        thread = thread();
        stuck.shutdownNow().forEach(thread::execute);
    }

    /** Ends the thread once work under way has ended. */
    @Override
    public synchronized void close() {
        closed = true;
        thread.shutdown();
    }
}
