package troupe.crowd;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.ForkJoinPool;
import java.util.function.Predicate;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Flock;
import troupe.crowd.flock.Kin;
import troupe.crowd.flock.Sweep;
import troupe.crowd.ground.Ground;
import troupe.grid.GridLimitException;
import troupe.run.Inputs;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.scene.Crowd;
import troupe.scene.Scene;
import troupe.scene.setting.CrowdSettings;
import troupe.search.Outcome;

/**
 * Simulates a crowd step by step. The first step places everybody, each later one moves them by {@link
 * Crowd#STEP_SECONDS}; there is a frame for each. It ends as found when all have arrived, as exhausted when the task's
 * seconds are over, and as infeasible when a group has no room or no way. Everything but the times in the report
 * depends on scene, task and inputs only.
 */
public final class CrowdEngine implements Simulation {
    private final Scene scene;
    private final Crowd crowd;
    private final Sweep sweep;
    private final Kin kin;
    private final Agents agents;
    private final CrowdFrames frames;
    private final long limit;
    private final Inputs inputs = new Inputs();
    private final CrowdReport report;
    private Crowd tuned;
    private Ground ground;
    private Flock flock;
    private Splitting splitting;
    private CrowdViews views;
    private Outcome outcome = Outcome.RUNNING;
    private long steps;

    /** Prepares a crowd of a scene that has passed the checks, on the threads of the common pool; no work is done yet. */
    public static CrowdEngine of(Scene scene, Crowd crowd) {
        return new CrowdEngine(scene, crowd, Sweep.on(ForkJoinPool.commonPool()));
    }

    /** Prepares a crowd whose work is spread by {@code sweep}. */
    public CrowdEngine(Scene scene, Crowd crowd, Sweep sweep) {
        this.scene = scene;
        this.crowd = crowd;
        this.tuned = crowd;
        this.sweep = sweep;
        this.kin = new Kin(crowd);
        this.agents = new Agents(kin.agents());
        this.frames = new CrowdFrames(kin, agents);
        this.limit = (long) Math.ceil(crowd.seconds() / Crowd.STEP_SECONDS - 1e-9) + 1;
        this.report = new CrowdReport(crowd, kin, agents);
    }

    @Override
    public Outcome step(long budget) {
        if (budget < 1) {
            throw new IllegalArgumentException("budget=" + budget + "; needs at least 1");
        }
        sweep.whole(() -> advance(budget));
        return outcome;
    }

    private void advance(long budget) {
        for (long k = 0; k < budget && outcome.isRunning(); k++) {
            long begin = System.nanoTime();
            if (steps == 0) {
                prepare();
                report.prepared(System.nanoTime() - begin);
            } else {
                takeInputs();
                if (splitting.renew(steps)) {
                    flock.renewed();
                }
                flock.step(steps);
                report.moved(System.nanoTime() - begin);
            }
            if (outcome.isRunning()) {
                frames.record();
                steps++;
                end();
            }
        }
    }

    private void prepare() {
        try {
            ground = new Ground(scene, crowd);
            double[] world = {scene.world().width(), scene.world().depth()};
            Beginning beginning = new Beginning(scene, crowd, kin, agents, ground);
            for (int number = 0; number < kin.leaves().size(); number++) {
                Optional<String> fault = beginning.place(number);
                if (fault.isPresent()) {
                    outcome = new Outcome.Infeasible(fault.get());
                    return;
                }
            }
            views = new CrowdViews(scene, kin, ground);
            splitting = new Splitting(crowd, kin, ground, agents, world);
            flock = new Flock(crowd, kin, agents, world[0], world[1], sweep);
        } catch (GridLimitException tooMuch) {
            outcome = new Outcome.Infeasible(tooMuch.getMessage());
        }
    }

    private void takeInputs() {
        Crowd before = tuned;
        inputs.take(steps, input -> tuned = CrowdSettings.with(tuned, input.key(), input.value()));
        if (tuned != before) {
            flock.take(tuned);
        }
    }

    private void end() {
        boolean all = true;
        for (int i = 0; i < agents.count && all; i++) {
            all = agents.state[i] == Agents.ARRIVED;
        }
        if (all) {
            outcome = Outcome.FOUND;
        } else if (steps >= limit) {
            outcome = Outcome.EXHAUSTED;
        }
    }

    @Override
    public List<Control> controls() {
        return CrowdSettings.live(crowd).stream()
                .map(l -> new Control(l.key(), crowd.id(), "", l.min(), l.max(), l.value()))
                .toList();
    }

    @Override
    public void give(Run.Input input) {
        inputs.give(input, controls(), steps);
    }

    @Override
    public Outcome outcome() {
        return outcome;
    }

    @Override
    public void cancel() {
        if (outcome.isRunning()) {
            outcome = Outcome.CANCELLED;
        }
    }

    @Override
    public Progress progress() {
        return new Progress(steps, outcome.isRunning() ? (double) steps / limit : 1);
    }

    @Override
    public List<Overlay> overlays() {
        return overlays(List.of());
    }

    @Override
    public List<Aspect> aspects(List<Integer> chosen) {
        return views == null ? List.of() : views.aspects();
    }

    @Override
    public List<Overlay> overlays(List<Integer> chosen) {
        return overlays(chosen, key -> true);
    }

    @Override
    public List<Overlay> overlays(List<Integer> chosen, Predicate<String> wanted) {
        return views == null ? List.of() : views.overlays(chosen, wanted);
    }

    /** Returns the state of the agents as it is now; not to be changed. */
    public Agents agents() {
        return agents;
    }

    /** Returns how many others were looked at for each move of an agent on its way, on average; 0 before the first. */
    public double visitsPerMove() {
        return flock == null || flock.moves() == 0 ? 0 : (double) flock.visits() / flock.moves();
    }

    @Override
    public Run run() {
        return new Run(scene, crowd.id(), outcome, report.build(flock), frames.frames(), List.of(), inputs.all());
    }
}
