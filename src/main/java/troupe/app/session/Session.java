package troupe.app.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import troupe.app.document.EventThread;
import troupe.app.document.Listeners;
import troupe.app.document.SceneDocument;
import troupe.app.document.Selection;
import troupe.app.look.Failures;
import troupe.app.plan.Intervention;
import troupe.app.plan.LivePlanner;
import troupe.app.plan.Plan;
import troupe.app.plan.PlanningSteps;
import troupe.app.plan.Snapshot;
import troupe.app.plan.Work;
import troupe.app.play.Playback;
import troupe.exchange.format.ExchangeException;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/**
 * Holds one document and everything that lives with it: selection, planner, the newest plan, playback,
 * the views that are shown, and its file. Each change of the scene asks for a plan, while live planning
 * is on. Belongs to the event thread.
 */
public final class Session implements AutoCloseable {
    private final SceneDocument document;
    private final Selection selection = new Selection();
    private final Playback playback = new Playback();
    private final OverlayChoice overlays =
            new OverlayChoice(List.of(OverlayChoice.PLAN, OverlayChoice.LEGEND, OverlayChoice.TRAILS, "skeleton"));
    private final LivePlanner planner;
    private final SceneFiles files;
    private final Executor eventThread;
    private final ExecutorService background = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "files");
        thread.setDaemon(true);
        return thread;
    });
    private final Listeners<Plan> plans = new Listeners<>();
    private final Listeners<Notice> notices = new Listeners<>();
    private Optional<Plan> plan = Optional.empty();
    private Work work = Work.IDLE;
    private List<Integer> looked = List.of();
    private boolean live = true;
    private final Comparison comparison = new Comparison();
    private boolean saved;

    /** Makes a session of a document; nothing is planned before {@link #planNow()} or the first change. */
    public Session(SceneDocument document, PlanningSteps steps, SceneFiles files, Executor eventThread) {
        this.document = document;
        this.files = files;
        this.eventThread = eventThread;
        this.planner = new LivePlanner(steps, eventThread);
        planner.plans().add(newer -> {
            if (!saved) {
                take(newer);
            }
        });
        planner.works().add(now -> work = now);
        document.listeners().add(this::changed);
        overlays.listeners().add(choice -> look());
        planner.show(overlays.needed());
        playback.listeners().add(p -> planner.intervention().pace(frame()));
    }

    /** Returns the document. */
    public SceneDocument document() {
        return document;
    }

    /** Returns what is selected in it. */
    public Selection selection() {
        return selection;
    }

    /** Returns the clock of the run. */
    public Playback playback() {
        return playback;
    }

    /** Returns which views are shown. */
    public OverlayChoice overlays() {
        return overlays;
    }

    /** Returns the planner. */
    public LivePlanner planner() {
        return planner;
    }

    /** Returns the newest plan, empty until there is one. It may be older than the scene shown. */
    public Optional<Plan> plan() {
        return plan;
    }

    /** Returns the run of the newest plan, empty if there is none. */
    public Optional<Run> run() {
        return plan.flatMap(Plan::run);
    }

    /** Returns the observers of the newest plan. */
    public Listeners<Plan> plans() {
        return plans;
    }

    /** Returns what the planner is doing. */
    public Work work() {
        return work;
    }

    /** Returns the observers of messages to the person. */
    public Listeners<Notice> notices() {
        return notices;
    }

    /** Tells whether each change asks for a plan. */
    public boolean isLive() {
        return live;
    }

    /** Switches live planning; switched on, it plans at once what is shown. */
    public void setLive(boolean on) {
        EventThread.require();
        live = on;
        if (on) {
            planNow();
        }
    }

    /** Asks for a plan of what is shown. */
    public void planNow() {
        saved = false;
        planner.request(new Snapshot(document.version(), document.shown(), document.task()));
    }

    /** Returns the run that is kept to be compared with the one shown. */
    public Comparison comparison() {
        return comparison;
    }

    /**
     * Shows a saved run: its scene becomes a document that belongs to no file, and it plays as it was saved. Live
     * planning is switched off; the next plan takes the place of the run.
     */
    public void show(Run run) {
        EventThread.require();
        live = false;
        saved = true;
        planner.cancel();
        document.open(run.scene(), Optional.empty());
        document.lookAt(run.task());
        Snapshot of = new Snapshot(document.version(), document.shown(), document.task());
        take(new Plan(of, Optional.of(run), List.of(), 0));
    }

    /** Takes hold of the simulation that is shown, at the moment shown; see {@link Intervention#grab}. */
    public void grab() {
        planner.intervention().grab(frame() + 1);
    }

    /** Sets a value of the simulation that is held, from now on. */
    public void steer(String control, double value) {
        planner.intervention().set(control, value);
    }

    /** Lets go of the simulation. */
    public void release() {
        planner.intervention().release();
    }

    private long frame() {
        double rate = run().map(r -> r.frames().rate()).orElse(25.0);
        return (long) Math.floor(playback.time() * rate + 1e-6);
    }

    private void look() {
        planner.show(overlays.needed());
        if (!looked.equals(overlays.chosen())) {
            looked = overlays.chosen();
            planner.look(looked);
        }
    }

    private void changed(SceneDocument.Change change) {
        if (change == SceneDocument.Change.FILE) {
            return;
        }
        if (change == SceneDocument.Change.OPENED) {
            plan = Optional.empty();
            selection.clear();
            playback.load(0, 25);
        }
        if (change == SceneDocument.Change.OPENED || change == SceneDocument.Change.TASK) {
            planner.forget();
            overlays.chooseFirst();
            look();
        }
        selection.retain(document.shown());
        if (live || change == SceneDocument.Change.OPENED && !saved) {
            planNow();
        }
    }

    private void take(Plan newer) {
        boolean sameRun = plan.isPresent() && plan.get().run().equals(newer.run());
        plan = Optional.of(newer);
        if (!sameRun) {
            Optional<Frames> frames = newer.run().map(Run::frames);
            playback.load(
                    frames.map(Frames::duration).orElse(0.0),
                    frames.map(Frames::rate).orElse(25.0),
                    newer.run().filter(r -> r.outcome().isRunning()).isPresent());
        }
        plans.tell(newer);
    }

    /** Returns what reads and writes scene files, on a background thread. */
    public SceneFiles files() {
        return files;
    }

    /** Opens a file in place of the document; a file that cannot be read leaves it as it is, with a notice. */
    public void open(Path file) {
        open(file, Optional.of(file));
    }

    /** Opens what a file holds as a new document, which belongs to no file yet. */
    public void openCopy(Path file) {
        open(file, Optional.empty());
    }

    private void open(Path file, Optional<Path> belongs) {
        EventThread.require();
        background.execute(() -> {
            try {
                Scene read = files.read(file);
                eventThread.execute(() -> document.open(read, belongs));
            } catch (SceneException | IOException e) {
                tell(new Notice(true, Failures.line(file, e)));
            }
        });
    }

    /**
     * Puts the scene that another program's file describes in place of the one shown, as one step of the history; a file
     * that cannot be read leaves everything as it is, with a notice.
     *
     * @param step the name of the step
     * @param then what is done after it
     */
    public void importFrom(Path file, String step, Runnable then) {
        EventThread.require();
        background.execute(() -> {
            try {
                Scene read = files.convert(file);
                eventThread.execute(() -> {
                    document.commit(step, read);
                    then.run();
                });
            } catch (ExchangeException | IOException e) {
                tell(new Notice(true, Failures.line(file, e)));
            }
        });
    }

    /** Writes the scene as it stands now to a file, which is then the document's. */
    public void save(Path file) {
        EventThread.require();
        Scene written = document.scene();
        background.execute(() -> {
            try {
                files.write(written, file);
                eventThread.execute(() -> document.savedAs(file, written));
            } catch (IOException e) {
                tell(new Notice(true, Failures.line(file, e)));
            }
        });
    }

    private void tell(Notice notice) {
        eventThread.execute(() -> notices.tell(notice));
    }

    /** Ends the background threads. */
    @Override
    public void close() {
        planner.close();
        background.shutdown();
    }
}
