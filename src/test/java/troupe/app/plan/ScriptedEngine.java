package troupe.app.plan;

import java.util.List;
import troupe.run.Engine;
import troupe.run.FrameRecorder;
import troupe.run.Overlay;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Scene;
import troupe.search.Outcome;

/** An engine that does a given number of steps and then ends as found; a step may do something. */
public final class ScriptedEngine implements Engine {
    private final Scene scene;
    private final String task;
    private final int steps;
    private final Runnable each;
    private final List<Run.Leg> legs;
    private int done;
    private Outcome outcome = Outcome.RUNNING;

    /** Makes an engine of {@code steps} steps, each of which runs {@code each}, that ends with these legs. */
    public ScriptedEngine(Scene scene, String task, int steps, List<Run.Leg> legs, Runnable each) {
        this.scene = scene;
        this.task = task;
        this.steps = steps;
        this.legs = legs;
        this.each = each;
    }

    @Override
    public Outcome step(long budget) {
        if (outcome.isRunning()) {
            each.run();
            done++;
            outcome = done >= steps ? Outcome.FOUND : outcome;
        }
        return outcome;
    }

    @Override
    public Outcome outcome() {
        return outcome;
    }

    @Override
    public void cancel() {
        outcome = outcome.isRunning() ? Outcome.CANCELLED : outcome;
    }

    @Override
    public Progress progress() {
        return new Progress(done, (double) done / steps);
    }

    @Override
    public List<Overlay> overlays() {
        return List.of(new Overlay.Points("trigger", 0, new double[] {1, 1}));
    }

    @Override
    public Run run() {
        return new Run(
                scene,
                task,
                outcome,
                Report.builder()
                        .put("steps", done)
                        .put("energy_by_ability", energy())
                        .build(),
                new FrameRecorder(25, List.of()).frames(),
                legs,
                List.of());
    }

    private Report energy() {
        Report.Builder joules = Report.builder();
        legs.forEach(leg -> joules.put(leg.ability(), leg.energy()));
        return joules.build();
    }
}
