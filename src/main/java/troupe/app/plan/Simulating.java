package troupe.app.plan;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.run.frame.FrameLayout;
import troupe.search.Outcome;

/**
 * Works a simulation on a background thread while its run is shown, and lets a person take part. Left alone it
 * runs ahead as far as there is. What the person does takes effect at the step that is shown: what was simulated
 * after it is dropped, the values given before it stay, and another engine is brought to that step, which makes
 * the same frames again: the {@link Understudy}, if it stands before that step, or a fresh one. The farther it is ahead of what is shown, the less often it tells, and the more it leaves a
 * small machine to the painting. Used by one thread at a time, but for {@link #steering()}.
 */
final class Simulating {
    private static final long SLICE_NANOS = TimeUnit.MILLISECONDS.toNanos(10);
    private static final long PUBLISH_NANOS = TimeUnit.MILLISECONDS.toNanos(40);
    private static final long WAIT_MS = 20;
    /** So many steps ahead of what is shown, what comes is told less often. */
    private static final long FAR_STEPS = 100;

    private static final long FAR_PUBLISH_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
    /** With so few processors, a simulation far ahead of what is played leaves room for the painting. */
    private static final boolean NARROW = Runtime.getRuntime().availableProcessors() <= 2;

    /** No understudy follows a run with more bytes of frames than this: it would hold them a second time. */
    private static final long MOST_BYTES = 1L << 28;

    private static final long SHORT_SLICE_NANOS = TimeUnit.MILLISECONDS.toNanos(4);
    private static final long REST_MS = 8;

    private final Supplier<Simulation> fresh;
    private final Steering steering = new Steering(this::follow);
    private final Understudy understudy;
    /** The inputs of the run since it has ended, null before: then there is something for the understudy to follow. */
    private volatile List<Run.Input> ended;

    private Simulation engine;
    private double[] stepMillis = new double[1_024];
    private volatile boolean working;

    /** Sees what comes of it, and says whether it is still wanted. */
    interface Watcher {
        /** Tells whether other work is wanted instead. */
        boolean isObsolete();

        /** Tells whether the person has cancelled it. */
        boolean isCancelled();

        /** Takes the run as far as it has come. */
        void publish(Run run, Live live);

        /** Takes how far the work has come. */
        void report(long done, double share);
    }

    /** Makes the work of an engine at its beginning, and of those that {@code fresh} starts of the same task. */
    Simulating(Simulation engine, Supplier<Simulation> fresh) {
        this.fresh = fresh;
        this.engine = engine;
        this.understudy = new Understudy(fresh);
    }

    /** Returns what the person wants. */
    Steering steering() {
        return steering;
    }

    /** Returns the engine as it is now. */
    Simulation engine() {
        return engine;
    }

    /**
     * Works until the task has ended and nothing is held, or until it is not wanted any more; tells whether it is
     * still wanted. May be called again when something is asked for after the end.
     */
    boolean work(Watcher watcher) throws InterruptedException {
        working = true;
        ended = null;
        try {
            boolean wanted = loop(watcher);
            Run run = engine.run();
            ended = wanted && bytes(run) <= MOST_BYTES ? run.inputs() : null;
            return wanted;
        } finally {
            working = false;
        }
    }

    private static long bytes(Run run) {
        return (long) run.frames().count() * new FrameLayout(run.frames().channels()).bytes();
    }

    /** Sends the understudy to a step that is shown. */
    private void follow(long step) {
        List<Run.Input> inputs = ended;
        if (inputs != null && !working) {
            understudy.follow(step, inputs);
        }
    }

    /** Tells whether it is at work, so that what is asked for will be done. */
    boolean isWorking() {
        return working;
    }

    private boolean loop(Watcher watcher) throws InterruptedException {
        long told = System.nanoTime() - PUBLISH_NANOS;
        boolean news = true;
        while (!watcher.isObsolete()) {
            if (watcher.isCancelled()) {
                engine.cancel();
                watcher.publish(engine.run(), live());
                return true;
            }
            news |= obey(watcher);
            // what was asked for and let go at once comes before the next step, not after a slice of them
            boolean asked = steering.isAsked();
            boolean on =
                    !asked && engine.outcome().isRunning() && engine.progress().work() < steering.limit();
            boolean far = steering.isFarAhead(engine.progress().work(), FAR_STEPS);
            boolean yields = NARROW && far && steering.isPlayed();
            if (on) {
                advance(yields ? SHORT_SLICE_NANOS : SLICE_NANOS);
                news = true;
            }
            boolean pausing = !asked && (!on || !engine.outcome().isRunning());
            if (news && (pausing || System.nanoTime() - told >= (far ? FAR_PUBLISH_NANOS : PUBLISH_NANOS))) {
                told = System.nanoTime();
                news = false;
                watcher.publish(engine.run(), live());
            }
            watcher.report(engine.progress().work(), engine.progress().share());
            if (!engine.outcome().isRunning() && steering.isIdle()) {
                working = false;
                if (steering.isIdle()) {
                    return true;
                }
                working = true;
            }
            if (!on) {
                long reach = engine.outcome().isRunning() ? engine.progress().work() : Steering.NONE;
                steering.await(reach, WAIT_MS);
            } else if (yields) {
                steering.rest(REST_MS);
            }
        }
        engine.cancel();
        return false;
    }

    /** Steps for a moment, one step at least, never past the limit. */
    private void advance(long nanos) {
        long begin = System.nanoTime();
        do {
            step();
        } while (engine.outcome().isRunning()
                && !steering.isAsked()
                && engine.progress().work() < steering.limit()
                && System.nanoTime() - begin < nanos);
    }

    /** Does what was asked for; tells whether the run has become another. */
    private boolean obey(Watcher watcher) {
        Steering.Orders orders = steering.take();
        boolean cut = engine.outcome().equals(Outcome.CANCELLED) && orders.back() != Steering.NONE;
        boolean rewound = cut || orders.back() < engine.progress().work();
        if (rewound) {
            rewind(orders.back(), watcher);
        }
        long step = engine.progress().work();
        orders.values().forEach((key, value) -> {
            if (engine.outcome().isRunning()) {
                engine.give(new Run.Input(step, key, value));
            }
        });
        return rewound;
    }

    private void rewind(long step, Watcher watcher) {
        List<Run.Input> kept = engine.run().inputs().stream()
                .filter(input -> input.step() < step)
                .toList();
        engine = understudy.take(step, kept).orElseGet(fresh);
        long done = engine.progress().work();
        kept.stream().filter(input -> input.step() >= done).forEach(engine::give);
        while (engine.progress().work() < step
                && engine.outcome().isRunning()
                && !watcher.isObsolete()
                && !watcher.isCancelled()) {
            step();
        }
    }

    private void step() {
        int step = (int) engine.progress().work();
        long begin = System.nanoTime();
        engine.step(1);
        if (step == stepMillis.length) {
            stepMillis = Arrays.copyOf(stepMillis, 2 * step);
        }
        stepMillis[step] = (System.nanoTime() - begin) / 1e6;
    }

    private Live live() {
        return new Live(engine.controls(), Arrays.copyOf(stepMillis, (int)
                engine.progress().work()));
    }
}
