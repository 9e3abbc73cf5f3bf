package troupe.app.plan;

import java.util.List;
import java.util.Optional;
import troupe.run.Overlay;
import troupe.run.Run;
import troupe.scene.Problem;

/**
 * Holds what came of planning a snapshot. Immutable.
 *
 * @param run what was planned; empty where the scene's errors, or its lack of a task, forbid it
 * @param problems what is wrong with the scene, worst first
 * @param overlays the views that the planner offers; empty until they have been made
 * @param routes the routes that other preferences would give; empty until they have been planned
 * @param millis how long planning took, views and other routes not counted
 */
public record Plan(
        Snapshot snapshot,
        Optional<Run> run,
        List<Problem> problems,
        List<Overlay> overlays,
        List<Route> routes,
        double millis) {

    /** Copies the lists. */
    public Plan {
        problems = List.copyOf(problems);
        overlays = List.copyOf(overlays);
        routes = List.copyOf(routes);
    }

    /** Returns this plan with its views. */
    public Plan withOverlays(List<Overlay> made) {
        return new Plan(snapshot, run, problems, made, routes, millis);
    }

    /** Returns this plan with all that is wrong with its scene. */
    public Plan withProblems(List<Problem> found) {
        return new Plan(snapshot, run, found, overlays, routes, millis);
    }

    /** Returns this plan with other routes beside it. */
    public Plan withRoutes(List<Route> planned) {
        return new Plan(snapshot, run, problems, overlays, planned, millis);
    }
}
