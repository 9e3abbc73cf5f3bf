package troupe.app.plan;

import java.util.List;
import troupe.run.Engine;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.FrameRecorder;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
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

    /** Offers two spaces, the second with two instances. */
    @Override
    public List<Aspect> aspects(List<Integer> chosen) {
        Aspect space = new Aspect("space", List.of(Aspect.Choice.of("scene"), Aspect.Choice.of("moved", "Crate")));
        Aspect.Choice plain = Aspect.Choice.of("plain");
        boolean moved = space.chosen(chosen, 0) == 1;
        return List.of(
                space, new Aspect("instance", moved ? List.of(plain, plain) : List.of(plain), List.of("trigger")));
    }

    @Override
    public List<Overlay> overlays(List<Integer> chosen) {
        double x = aspects(chosen).get(0).chosen(chosen, 0);
        return List.of(new Overlay.Points("trigger", 0, new double[] {1 + x, 1}));
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
