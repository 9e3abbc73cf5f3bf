package troupe.app.plan;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.UnaryOperator;
import troupe.app.document.EventThread;
import troupe.app.document.Listeners;
import troupe.app.document.Version;
import troupe.run.Engine;
import troupe.run.Overlay;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.search.Outcome;
import troupe.work.Explainer;
import troupe.work.Explanation;

/**
 * Plans the newest snapshot on a background thread. A new request makes the one before it obsolete:
 * after a change of the document at once; within a gesture, where a request comes with each move of the
 * pointer, the work under way may go on for {@link #PATIENCE_MS}, or nothing would ever be shown. What
 * comes back is told on the event thread, and only if it is of the revision asked for last and newer
 * than what was told before. A snapshot is told more than once: its plan, then with its views, and, when it
 * is no moment of a gesture, with all problems, and with what else could be done. Work that is cancelled or
 * of an older revision and does not end within {@link #GRACE_MS} is left behind: its thread is interrupted,
 * nothing that it makes is told, and another thread takes over.
 */
public final class LivePlanner implements AutoCloseable {
    /** How long in ms work for an earlier moment of the same gesture may go on. */
    public static final long PATIENCE_MS = 200;

    /** How long in ms work that is not wanted any more may take to end before it is left behind. */
    public static final long GRACE_MS = 70;

    /** How many threads may be left behind at a time; more unwanted work is waited for. */
    private static final int LEFT_BEHIND = 3;

    private static final long SLICE = 1_000;
    private static final long REPORT_MS = 60;

    private final PlanningSteps steps;
    private final Executor eventThread;
    private final long patienceMs;
    private final AtomicReference<Watch> current = new AtomicReference<>();
    private final AtomicInteger leftBehind = new AtomicInteger();
    private final Listeners<Plan> plans = new Listeners<>();
    private final Listeners<Work> works = new Listeners<>();
    private volatile Snapshot newest;
    private volatile Simulated simulated;
    private final Intervention intervention = new Intervention(
            () -> Optional.ofNullable(simulated)
                    .filter(s -> s.snapshot() == newest)
                    .map(s -> s.work().steering()),
            this::wake);
    private volatile ThreadPoolExecutor worker = worker();
    private volatile Snapshot cancelled;
    private volatile Watch seen;
    private volatile List<Integer> chosen = List.of();
    private Version told = new Version(-1, 0);

    /** The simulation of a snapshot. */
    private record Simulated(Snapshot snapshot, Simulating work) {}

    /** Makes a planner that tells its results through {@code eventThread}. */
    public LivePlanner(PlanningSteps steps, Executor eventThread) {
        this(steps, eventThread, PATIENCE_MS);
    }

    /** Makes a planner that lets work for an earlier moment of a gesture go on for {@code patienceMs}. */
    LivePlanner(PlanningSteps steps, Executor eventThread, long patienceMs) {
        this.steps = steps;
        this.eventThread = eventThread;
        this.patienceMs = patienceMs;
    }

    private static ThreadPoolExecutor worker() {
        return new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
            Thread thread = new Thread(task, "planning");
            thread.setDaemon(true);
            return thread;
        });
    }

    /** Returns the observers of what was planned. */
    public Listeners<Plan> plans() {
        return plans;
    }

    /** Returns the observers of how far the work has come. */
    public Listeners<Work> works() {
        return works;
    }

    /** Returns what lets a person take part in the simulation that is shown. */
    public Intervention intervention() {
        return intervention;
    }

    /** Asks for a plan of a snapshot; the newest request wins. */
    public void request(Snapshot snapshot) {
        EventThread.require();
        newest = snapshot;
        ThreadPoolExecutor by = worker;
        by.execute(() -> work(snapshot, by));
        leaveUnlessEnded(current.get());
    }

    /**
     * Makes the views of the newest plan anew, of another choice of its aspects; every plan from now on has
     * those of this choice. Work under way is not cancelled: what explains the plan goes on after the views.
     */
    public void look(List<Integer> choices) {
        EventThread.require();
        chosen = List.copyOf(choices);
        ThreadPoolExecutor by = worker;
        by.execute(() -> {
            Watch watch = seen;
            if (watch != null && worker == by) {
                current.set(watch);
                watch.look();
                if (!current.compareAndSet(watch, null) && watch.left) {
                    leftBehind.decrementAndGet();
                }
            }
        });
    }

    /**
     * Cancels the work under way. A search ends with the outcome cancelled; of work that has told its plan,
     * or does not end at once, nothing more is told.
     */
    public void cancel() {
        Snapshot unwanted = newest;
        cancelled = unwanted;
        eventThread.execute(() -> {
            if (newest == unwanted) {
                works.tell(Work.IDLE);
            }
        });
        leaveUnlessEnded(current.get());
    }

    /** Ends the background thread; work under way is cancelled. */
    @Override
    public void close() {
        newest = null;
        seen = null;
        worker.shutdown();
    }

    private void leaveUnlessEnded(Watch watch) {
        if (watch != null) {
            CompletableFuture.delayedExecutor(GRACE_MS, TimeUnit.MILLISECONDS, eventThread)
                    .execute(() -> leave(watch));
        }
    }

    /** Goes on with another thread if work under way is not wanted any more. */
    private void leave(Watch watch) {
        Snapshot asked = newest;
        if (asked == null || current.get() != watch || !watch.isUnwanted()) {
            return;
        }
        if (leftBehind.get() >= LEFT_BEHIND) {
            leaveUnlessEnded(watch);
            return;
        }
        watch.left = true;
        leftBehind.incrementAndGet();
        ThreadPoolExecutor stuck = worker;
        ThreadPoolExecutor fresh = worker();
        worker = fresh;
        if (!current.compareAndSet(watch, null)) {
            leftBehind.decrementAndGet(); // it has ended just now
        }
        stuck.shutdownNow();
        if (asked != watch.snapshot) {
            fresh.execute(() -> work(asked, fresh));
        }
    }

    private void work(Snapshot snapshot, ThreadPoolExecutor by) {
        if (newest != snapshot || worker != by) {
            return;
        }
        Watch watch = new Watch(snapshot);
        current.set(watch);
        try {
            Simulated one = simulated;
            if (one != null && one.snapshot() == snapshot && watch.goesOn()) {
                simulate(one, watch);
            } else {
                plan(snapshot, watch);
            }
        } catch (CancellationException e) {
            return; // not wanted any more: what was told before stays
        } finally {
            if (!current.compareAndSet(watch, null) && watch.left) {
                leftBehind.decrementAndGet();
            } else if (newest == snapshot) {
                eventThread.execute(() -> works.tell(Work.IDLE));
            }
        }
    }

    private void plan(Snapshot snapshot, Watch watch) {
        watch.report(0, Double.NaN);
        List<Problem> problems = steps.check(snapshot.scene());
        if (snapshot.task().isEmpty() || problems.stream().anyMatch(p -> p.severity() == Severity.ERROR)) {
            watch.tell(new Plan(snapshot, Optional.empty(), problems, watch.elapsedMs()));
            return;
        }
        Engine engine = steps.start(snapshot.scene(), snapshot.task());
        if (engine instanceof Simulation first) {
            watch.latest = new Plan(snapshot, Optional.empty(), problems, 0);
            simulated = new Simulated(snapshot, new Simulating(first, () -> restarted(snapshot)));
            simulate(simulated, watch);
        } else if (finish(engine, watch)) {
            watch.tell(new Plan(snapshot, Optional.of(engine.run()), problems, watch.elapsedMs()));
            tellMore(engine, watch);
        }
    }

    private Simulation restarted(Snapshot snapshot) {
        return (Simulation) steps.start(snapshot.scene(), snapshot.task());
    }

    /** Works a simulation while its run is shown, until it has ended or is not wanted any more. */
    private void simulate(Simulated one, Watch watch) {
        try {
            if (one.work().work(watch)) {
                tellMore(one.work().engine(), watch);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Tells the views of an engine that has ended, all problems, and what else could be done. */
    private void tellMore(Engine engine, Watch watch) {
        if (watch.isWanted()) {
            watch.see(engine);
            seen = watch;
            Snapshot snapshot = watch.snapshot;
            if (snapshot.version().preview() == 0 && watch.isWanted()) {
                List<Problem> all = steps.inspect(snapshot.scene());
                watch.tellWanted(p -> p.withProblems(all));
                explain(engine.run(), watch);
            }
        }
    }

    private void wake() {
        Simulated one = simulated;
        if (one != null && one.snapshot() == newest && !one.work().isWorking()) {
            if (cancelled == one.snapshot()) {
                cancelled = null;
            }
            ThreadPoolExecutor by = worker;
            by.execute(() -> work(one.snapshot(), by));
        }
    }

    /** Works until the task has ended, and tells whether it has: not if it became obsolete before. */
    private boolean finish(Engine engine, Watch watch) {
        Outcome outcome = engine.outcome();
        while (outcome.isRunning()) {
            outcome = engine.step(SLICE);
            watch.look();
            if (watch.isObsolete()) {
                engine.cancel();
                return false;
            }
            if (watch.isCancelled()) {
                engine.cancel();
                return true;
            }
            Engine.Progress progress = engine.progress();
            watch.report(progress.work(), progress.share());
        }
        return true;
    }

    /** Plans what else could be done: first without abilities, then at other preferences. */
    private void explain(Run run, Watch watch) {
        if (!run.outcome().isFound()) {
            return;
        }
        Explainer explainer = new Explainer((scene, task) -> {
            Engine engine = steps.start(scene, task);
            if (!watch.isWanted()) {
                engine.cancel();
            } else {
                finish(engine, watch);
            }
            return engine.run();
        });
        try {
            Explanation routes = explainer.routes(run);
            watch.tellWanted(p -> p.explained(routes));
            Explanation whole = explainer.flips(routes);
            watch.tellWanted(p -> p.explained(whole));
        } catch (CancellationException e) {
            return; // a newer request, or the person, ended it: what was told before stays
        }
    }

    /** Watches one piece of work: whether it is still wanted, and when to report. */
    private final class Watch implements Simulating.Watcher {
        private final Snapshot snapshot;
        private final long begin = System.nanoTime();
        private volatile boolean left;
        private volatile Plan latest;
        private Engine engine;
        private List<Integer> looked = List.of();
        private long reported = begin - TimeUnit.MILLISECONDS.toNanos(REPORT_MS);

        private Watch(Snapshot snapshot) {
            this.snapshot = snapshot;
        }

        private double elapsedMs() {
            return (System.nanoTime() - begin) / 1e6;
        }

        /** Tells the plan with the views of an engine that has ended. */
        private void see(Engine ended) {
            engine = ended;
            Plan plan = viewed();
            tellWanted(p -> plan);
        }

        /** Tells the views of another choice, if there is one and the plan has views. */
        private void look() {
            if (engine != null && !looked.equals(chosen) && newest == snapshot && !left) {
                tell(viewed());
            }
        }

        private Plan viewed() {
            looked = chosen;
            List<Overlay> views = steps.overlays(snapshot.scene(), snapshot.task(), engine, looked);
            return latest.withOverlays(views, engine.aspects(looked));
        }

        private void tell(Plan plan) {
            latest = plan;
            eventThread.execute(() -> {
                Version version = plan.snapshot().version();
                Snapshot asked = newest;
                if (!left
                        && asked != null
                        && asked.version().revision() == version.revision()
                        && version.compareTo(told) >= 0) {
                    told = version;
                    plans.tell(plan);
                }
            });
        }

        /** Tells more of the plan unless the person has cancelled this work. */
        private void tellWanted(UnaryOperator<Plan> more) {
            if (!isCancelled()) {
                tell(more.apply(latest));
            }
        }

        private boolean isWanted() {
            return newest == snapshot && !isCancelled() && !left;
        }

        /** Tells whether this work was cancelled or is of another revision than the one asked for. */
        private boolean isUnwanted() {
            Snapshot asked = newest;
            return isCancelled()
                    || asked == null
                    || asked.version().revision() != snapshot.version().revision();
        }

        @Override
        public boolean isCancelled() {
            return cancelled == snapshot;
        }

        @Override
        public boolean isObsolete() {
            Snapshot asked = newest;
            if (asked == snapshot) {
                return false;
            }
            return asked == null
                    || asked.version().revision() != snapshot.version().revision()
                    || elapsedMs() > patienceMs;
        }

        @Override
        public void publish(Run run, Live live) {
            tell(latest.grown(run, live, elapsedMs()));
        }

        /** Takes over what was told last, if that was of the same snapshot. */
        private boolean goesOn() {
            Watch last = seen;
            if (last != null && last.snapshot == snapshot) {
                latest = last.latest;
            }
            return latest != null;
        }

        @Override
        public void report(long done, double share) {
            long now = System.nanoTime();
            if (now - reported >= TimeUnit.MILLISECONDS.toNanos(REPORT_MS)) {
                reported = now;
                eventThread.execute(() -> {
                    if (isWanted()) {
                        works.tell(new Work(true, done, share));
                    }
                });
            }
        }
    }
}
