package troupe.app.plan;

import java.util.List;
import java.util.Optional;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.check.Problem;
import troupe.work.explain.Explanation;

/**
 * Holds what came of planning a snapshot. Immutable.
 *
 * @param run what was planned; empty where the scene's errors, or its lack of a task, forbid it
 * @param problems what is wrong with the scene, worst first
 * @param views the views that the planner offers; until they have been made those of an earlier plan, or none
 * @param why what else could be done; empty until it has been planned, and first without its flips
 * @param live what a simulation offers while it runs
 * @param millis how long planning took, views and explanation not counted
 */
public record Plan(
        Snapshot snapshot,
        Optional<Run> run,
        List<Problem> problems,
        Views views,
        Optional<Explanation> why,
        Live live,
        double millis) {

    /** Copies the list. */
    public Plan {
        problems = List.copyOf(problems);
    }

    /** Makes a plan without views and explanation. */
    public Plan(Snapshot snapshot, Optional<Run> run, List<Problem> problems, double millis) {
        this(snapshot, run, problems, Views.NONE, Optional.empty(), Live.NONE, millis);
    }

    /** Returns this plan with a run of a simulation as far as it has come, after {@code time} milliseconds of work. */
    public Plan grown(Run further, Live now, double time) {
        return new Plan(snapshot, Optional.of(further), problems, views, why, now, time);
    }

    /** Returns the views that the planner offers, as far as they have been made; see {@link Views#current}. */
    public List<Overlay> overlays() {
        return views.overlays();
    }

    /** Returns this plan with views. */
    public Plan withViews(Views made) {
        return new Plan(snapshot, run, problems, made, why, live, millis);
    }

    /** Returns this plan with all that is wrong with its scene. */
    public Plan withProblems(List<Problem> found) {
        return new Plan(snapshot, run, found, views, why, live, millis);
    }

    /** Returns this plan with what else could be done. */
    public Plan explained(Explanation explanation) {
        return new Plan(snapshot, run, problems, views, Optional.of(explanation), live, millis);
    }
}
