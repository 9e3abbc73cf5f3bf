package troupe.app.problem;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import troupe.app.document.Listeners;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.app.plan.Plan;
import troupe.app.plan.PlanningSteps;
import troupe.app.plan.Snapshot;
import troupe.app.session.Session;
import troupe.run.Engine;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.search.Outcome;
import troupe.work.inspect.Blockage;
import troupe.work.inspect.BlockageSearch;

/**
 * Looks at each new plan in the background: what can be done about its problems, and, where there is no way, what
 * stands in it and what would open it, which is planned to be sure; not while errors say why already. Older
 * looks are given up. Belongs to the
 * event thread.
 */
public final class Diagnosis implements AutoCloseable {
    private static final int SLICE = 2_000;
    private static final int MOST_TRIES = 4;

    private final Session session;
    private final PlanningSteps steps;
    private final Executor eventThread;
    private final Listeners<Findings> listeners = new Listeners<>();
    private final List<Runnable> leave = new ArrayList<>();
    private final ExecutorService background = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "diagnosis");
        thread.setDaemon(true);
        return thread;
    });
    private volatile Plan newest;
    private Findings findings = Findings.NONE;

    /** Makes the diagnosis of a session; {@code steps} plans what is tried. */
    public Diagnosis(Session session, PlanningSteps steps, Executor eventThread) {
        this.session = session;
        this.steps = steps;
        this.eventThread = eventThread;
        leave.add(session.plans().add(this::look));
        leave.add(session.document().listeners().add(change -> {
            if (change == SceneDocument.Change.OPENED) {
                newest = null;
                take(Findings.NONE);
            }
        }));
        session.plan().ifPresent(this::look);
    }

    /** Returns the observers of what was found. */
    public Listeners<Findings> listeners() {
        return listeners;
    }

    /** Returns what was found last. */
    public Findings findings() {
        return findings;
    }

    private void take(Findings found) {
        findings = found;
        listeners.tell(found);
    }

    private void look(Plan plan) {
        boolean blocked = isBlocked(plan);
        Plan before = newest;
        boolean same = before != null
                && before.snapshot() == plan.snapshot()
                && before.problems().equals(plan.problems())
                && isBlocked(before) == blocked;
        if (same) {
            return;
        }
        newest = plan;
        if (plan.problems().isEmpty() && !blocked) {
            if (findings != Findings.NONE) {
                take(Findings.NONE);
            }
            return;
        }
        background.execute(() -> {
            if (newest == plan) {
                diagnose(plan, blocked);
            }
        });
    }

    private static boolean isBlocked(Plan plan) {
        return plan.run()
                        .filter(run -> run.outcome() instanceof Outcome.Infeasible)
                        .isPresent()
                && plan.snapshot().scene().task(plan.snapshot().task()).orElse(null) instanceof Journey;
    }

    private void tell(Plan plan, Findings found) {
        eventThread.execute(() -> {
            if (newest == plan) {
                take(found);
            }
        });
    }

    private void diagnose(Plan plan, boolean blocked) {
        Snapshot snapshot = plan.snapshot();
        Scene scene = snapshot.scene();
        List<Finding> problems = new ArrayList<>();
        Set<List<String>> offered = new HashSet<>();
        for (Problem problem : plan.problems()) {
            List<Fix> fresh = Fixes.of(scene, problem).stream()
                    .filter(fix -> offered.add(List.of(fix.key(), problem.element(), fix.what())))
                    .toList();
            problems.add(new Finding(problem, fresh));
        }
        boolean wrong = plan.problems().stream().anyMatch(p -> p.severity() == Severity.ERROR);
        Optional<Blockage> blockage = blocked && !wrong
                ? BlockageSearch.of(scene, (Journey) scene.task(snapshot.task()).orElseThrow())
                : Optional.empty();
        tell(plan, new Findings(Optional.of(snapshot), problems, blockage, List.of()));
        if (blockage.isPresent() && snapshot.version().preview() == 0) {
            List<Fix> openings = openings(plan, blockage.get());
            tell(plan, new Findings(Optional.of(snapshot), problems, blockage, openings));
        }
    }

    /** Tries out what might open the way: letting a thing be moved, or taking it away. */
    private List<Fix> openings(Plan plan, Blockage blockage) {
        Scene scene = plan.snapshot().scene();
        Journey journey = (Journey) scene.task(plan.snapshot().task()).orElseThrow();
        List<String> suspects = new ArrayList<>(blockage.obstacles());
        blockage.gaps().forEach(gap -> suspects.addAll(List.of(gap.first(), gap.second())));
        List<Fix> found = new ArrayList<>();
        for (String id : suspects.stream().distinct().limit(MOST_TRIES).toList()) {
            if (scene.element(id).isPresent()) {
                tries(scene, journey, id).stream()
                        .filter(fix -> newest == plan && opens(plan, fix.mended()))
                        .findFirst()
                        .ifPresent(found::add);
            }
        }
        return found;
    }

    private static List<Fix> tries(Scene scene, Journey journey, String id) {
        List<Fix> tries = new ArrayList<>();
        String name = SceneEdits.name(scene, id);
        boolean moves = scene.actor(journey.actor()).flatMap(Actor::move).isPresent();
        scene.obstacle(id)
                .filter(o -> moves && !o.movable())
                .map(o -> new Obstacle(
                        o.id(), o.label(), o.outline(), o.offset(), o.height(), true, o.mass(), o.colour()))
                .ifPresent(o -> tries.add(new Fix("fix.movable", name, scene.with(o))));
        tries.add(new Fix("fix.remove", name, SceneEdits.removed(scene, List.of(id))));
        return tries;
    }

    private boolean opens(Plan plan, Scene changed) {
        Engine engine = steps.start(changed, plan.snapshot().task());
        Outcome outcome = engine.outcome();
        while (outcome.isRunning()) {
            if (newest != plan) {
                engine.cancel();
                return false;
            }
            outcome = engine.step(SLICE);
        }
        return outcome.isFound();
    }

    @Override
    public void close() {
        newest = null;
        leave.forEach(Runnable::run);
        background.shutdown();
    }
}
