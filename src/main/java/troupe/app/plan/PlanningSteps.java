package troupe.app.plan;

import java.util.List;
import java.util.function.Predicate;
import troupe.run.Engine;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.check.Problem;

/** Starts the work that the background thread does. Tests put guards around it. */
public interface PlanningSteps {

    /** Returns what is wrong with a scene, worst first, as far as it can be told at once. */
    List<Problem> check(Scene scene);

    /** Returns all that is wrong with a scene, worst first; may take as long as building a grid. */
    List<Problem> inspect(Scene scene);

    /**
     * Starts a task.
     *
     * @throws IllegalArgumentException if the scene holds no such task or cannot be planned
     */
    Engine start(Scene scene, String task);

    /**
     * Returns the views of a task that has been worked on: the engine's own and those of the grid below it.
     *
     * @param chosen what is chosen of the engine's aspects
     * @param wanted which views are needed, by their keys; others may be left out
     */
    List<Overlay> overlays(Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted);
}
