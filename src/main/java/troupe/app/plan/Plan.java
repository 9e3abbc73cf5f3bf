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
 * @param views the views that the planner offers; none until they have been made
 * @param routes the routes that other preferences would give; empty until they have been planned
 * @param millis how long planning took, views and other routes not counted
 */
public record Plan(
        Snapshot snapshot, Optional<Run> run, List<Problem> problems, Views views, List<Route> routes, double millis) {

    /** Copies the lists. */
    public Plan {
        problems = List.copyOf(problems);
        routes = List.copyOf(routes);
    }

    /** Returns the views that the planner offers; empty until they have been made. */
    public List<Overlay> overlays() {
        return views.overlays();
    }

    /** Returns this plan with its views. Cost O(their values). */
    public Plan withOverlays(List<Overlay> made) {
        return new Plan(snapshot, run, problems, Views.of(snapshot.scene(), made), routes, millis);
    }

    /** Returns this plan with all that is wrong with its scene. */
    public Plan withProblems(List<Problem> found) {
        return new Plan(snapshot, run, found, views, routes, millis);
    }

    /** Returns this plan with other routes beside it. */
    public Plan withRoutes(List<Route> planned) {
        return new Plan(snapshot, run, problems, views, planned, millis);
    }
}
