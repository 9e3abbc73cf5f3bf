package troupe.app.plan;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import troupe.app.document.EventThread;
import troupe.app.document.Listeners;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.search.Outcome;
import troupe.work.explain.Explainer;
import troupe.work.explain.Explanation;

/**
 * Plans the newest snapshot on a background thread. A new request makes the one before it obsolete:
 * after a change of the document at once; within a gesture, where a request comes with each move of the
 * pointer, the work under way may go on for {@link #PATIENCE_MS}, or nothing would ever be shown. What
 * comes back is told on the event thread, and only if it is of the revision asked for last and newer
 * than what was told before. A snapshot is told more than once: its plan, then with its views, and, when it
 * is no moment of a gesture, with all problems, and with what else could be done. Work that is cancelled or
 * of an older revision and does not end within {@link #GRACE_MS} is left behind: its thread is interrupted,
 * nothing that it makes is told, and another thread takes over.
 *
 * <p>No plan waits for the views of the one before: views are made on a thread of their own, always of the newest plan
 * that has none. Of moments of a gesture they are only those that are shown, and begun no more often than every {@link
 * Viewing#REST_MS}. Until newer ones are there, plans are told with the views of before.
 */
public final class LivePlanner implements AutoCloseable {
    /** How long in ms work for an earlier moment of the same gesture may go on. */
    public static final long PATIENCE_MS = 200;

    /** How long in ms work that is not wanted any more may take to end before it is left behind. */
    public static final long GRACE_MS = 40;

    private static final long SLICE = 1_000;

    private final PlanningSteps steps;
    private final long patienceMs;
    private final Announcer announcer;
    private final Worker planning;
    private final Viewing viewing;
    private volatile Simulated simulated;
    private final Intervention intervention = new Intervention(
            () -> Optional.ofNullable(simulated)
                    .filter(s -> s.snapshot() == newest())
                    .map(s -> s.work().steering()),
            this::wake);

    /** The simulation of a snapshot, and the plan that it was told with last. */
    private record Simulated(Snapshot snapshot, Simulating work) {}

    /** Makes a planner that tells its results through {@code eventThread}. */
    public LivePlanner(PlanningSteps steps, Executor eventThread) {
        this(steps, eventThread, PATIENCE_MS);
    }

    /** Makes a planner that lets work for an earlier moment of a gesture go on for {@code patienceMs}. */
    LivePlanner(PlanningSteps steps, Executor eventThread, long patienceMs) {
        this.steps = steps;
        this.patienceMs = patienceMs;
        this.announcer = new Announcer(eventThread);
        this.planning = new Worker("planning", eventThread);
        this.viewing = new Viewing(steps, announcer, planning, eventThread);
    }

    private Snapshot newest() {
        return announcer.newest();
    }

    /** Returns the observers of what was planned. */
    public Listeners<Plan> plans() {
        return announcer.plans();
    }

    /** Returns the observers of how far the work has come. */
    public Listeners<Work> works() {
        return announcer.works();
    }

    /** Returns what lets a person take part in the simulation that is shown. */
    public Intervention intervention() {
        return intervention;
    }

    /** Asks for a plan of a snapshot; the newest request wins. */
    public void request(Snapshot snapshot) {
        EventThread.require();
        announcer.ask(snapshot);
        submit(snapshot);
        planning.hurry();
        viewing.hurry();
    }

    private void submit(Snapshot snapshot) {
        Watch watch = new Watch(announcer, snapshot, patienceMs);
        planning.submit(watch, () -> work(watch));
    }

    /**
     * Makes the views of the newest plan anew, of another choice of its aspects; every plan from now on has
     * those of this choice. Work under way is not cancelled: what explains the plan goes on after the views.
     */
    public void look(List<Integer> choices) {
        EventThread.require();
        viewing.look(choices);
    }

    /** Says which views are shown, by their keys: those that moments of a gesture need. */
    public void show(Set<String> keys) {
        EventThread.require();
        viewing.show(keys);
    }

    /** Forgets the views of before: what is asked for next is of another document or task. */
    public void forget() {
        EventThread.require();
        announcer.forget();
    }

    /**
     * Cancels the work under way. A search ends with the outcome cancelled; of work that has told its plan,
     * or does not end at once, nothing more is told.
     */
    public void cancel() {
        announcer.cancel();
        planning.hurry();
        viewing.hurry();
    }

    /** Ends the background threads; work under way is cancelled. */
    @Override
    public void close() {
        announcer.ask(null);
        planning.close();
        viewing.close();
    }

    private void work(Watch watch) {
        Snapshot snapshot = watch.snapshot();
        if (newest() != snapshot) {
            return;
        }
        watch.begin();
        try {
            Simulated one = simulated;
            if (one != null && one.snapshot() == snapshot && viewing.goesOn(watch)) {
                simulate(one, watch);
            } else {
                plan(watch);
            }
        } catch (CancellationException e) {
            announcer.idle(snapshot); // not wanted any more: what was told before stays
        }
    }

    private void plan(Watch watch) {
        Snapshot snapshot = watch.snapshot();
        watch.report(0, Double.NaN);
        List<Problem> problems = steps.check(snapshot.scene());
        if (snapshot.task().isEmpty() || problems.stream().anyMatch(p -> p.severity() == Severity.ERROR)) {
            watch.tell(new Plan(snapshot, Optional.empty(), problems, watch.elapsedMs()));
            announcer.idle(snapshot);
            return;
        }
        Engine engine = steps.start(snapshot.scene(), snapshot.task());
        if (engine instanceof Simulation first) {
            watch.goOnFrom(new Plan(snapshot, Optional.empty(), problems, 0));
            simulated = new Simulated(snapshot, new Simulating(first, () -> restarted(snapshot)));
            simulate(simulated, watch);
        } else if (finish(engine, watch)) {
            Run run = engine.run();
            watch.tell(new Plan(snapshot, Optional.of(run), problems, watch.elapsedMs()));
            if (watch.isMoment()) {
                announcer.idle(snapshot);
            }
            viewing.view(watch, engine, () -> tellMore(run, watch));
        }
    }

    private Simulation restarted(Snapshot snapshot) {
        return (Simulation) steps.start(snapshot.scene(), snapshot.task());
    }

    /** Works a simulation while its run is shown, until it has ended or is not wanted any more. */
    private void simulate(Simulated one, Watch watch) {
        try {
            if (one.work().work(watch)) {
                viewing.viewHere(watch, one.work().engine());
                tellMore(one.work().engine().run(), watch);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Tells all problems, and what else could be done, of what is no moment of a gesture. */
    private void tellMore(Run run, Watch watch) {
        if (!watch.isMoment() && watch.isWanted()) {
            List<Problem> all = steps.inspect(watch.snapshot().scene());
            watch.tellWanted(p -> p.withProblems(all));
            explain(run, watch);
        }
        announcer.idle(watch.snapshot());
    }

    private void wake() {
        Simulated one = simulated;
        if (one != null && one.snapshot() == newest() && !one.work().isWorking()) {
            announcer.resume(one.snapshot());
            submit(one.snapshot());
        }
    }

    /** Works until the task has ended, and tells whether it has: not if it became obsolete before. */
    private boolean finish(Engine engine, Watch watch) {
        Outcome outcome = engine.outcome();
        while (outcome.isRunning()) {
            outcome = engine.step(SLICE);
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
}
