package troupe.app;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import troupe.app.plan.PlanningSteps;
import troupe.app.plan.ScriptedEngine;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.check.Problem;

/** Starts engines that do what a test says, and counts them. */
public final class ScriptedSteps implements PlanningSteps {
    private final AtomicInteger started = new AtomicInteger();
    private final int steps;
    private final Runnable each;

    /** Makes steps whose engines take {@code steps} steps, each of which runs {@code each}. */
    public ScriptedSteps(int steps, Runnable each) {
        this.steps = steps;
        this.each = each;
    }

    /** Returns how many engines were started. */
    public int started() {
        return started.get();
    }

    @Override
    public List<Problem> check(Scene scene) {
        return List.of();
    }

    @Override
    public List<Problem> inspect(Scene scene) {
        return List.of();
    }

    @Override
    public Engine start(Scene scene, String task) {
        started.incrementAndGet();
        Run.Leg leg = new Run.Leg("ann", "walk", "", 0, 2, 3, List.of(new double[] {1, 1, 0}, new double[] {4, 5, 0}));
        return new ScriptedEngine(scene, task, steps, List.of(leg), each);
    }

    @Override
    public List<Overlay> overlays(
            Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
        return engine.overlays(chosen, wanted);
    }
}
