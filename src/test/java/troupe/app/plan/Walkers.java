package troupe.app.plan;

import java.util.ArrayList;
import java.util.List;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.search.Outcome;

/** A simulation of one thing that goes on by its speed at each step; the speed is its one control. */
public final class Walkers implements Simulation {
    private final Scene scene;
    private final String task;
    private final int steps;
    private final FrameRecorder recorder =
            new FrameRecorder(25, List.of(new Channel("x", "m", Channel.Type.F64, "ann", 1)));
    private final List<Run.Input> inputs = new ArrayList<>();
    private Outcome outcome = Outcome.RUNNING;
    private double x;
    private double speed = 1;
    private int taken;
    private long done;

    /** Makes a simulation of so many steps. */
    public Walkers(Scene scene, String task, int steps) {
        this.scene = scene;
        this.task = task;
        this.steps = steps;
    }

    @Override
    public Outcome step(long budget) {
        for (long k = 0; k < budget && outcome.isRunning(); k++) {
            while (taken < inputs.size() && inputs.get(taken).step() <= done) {
                speed = inputs.get(taken++).value();
            }
            x += speed;
            recorder.append(x);
            outcome = ++done >= steps ? Outcome.FOUND : outcome;
        }
        return outcome;
    }

    @Override
    public List<Control> controls() {
        return List.of(new Control("speed", "ann", "m", 0, 9, 1));
    }

    @Override
    public void give(Run.Input input) {
        if (input.step() < done) {
            throw new IllegalArgumentException("step " + input.step() + " is over");
        }
        inputs.add(input);
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
        return List.of();
    }

    @Override
    public Run run() {
        return new Run(
                scene, task, outcome, Report.builder().build(), recorder.frames(), List.of(), List.copyOf(inputs));
    }
}
