package troupe.work;

import java.util.List;
import java.util.function.BiFunction;
import troupe.crowd.CrowdEngine;
import troupe.risk.EncounterEngine;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.RunException;
import troupe.run.Simulation;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.unified.JourneyEngine;

/** Starts any task of a scene. A new planner is one more line of {@link #KINDS}. */
public final class Tasks {
    private static final List<Kind<?>> KINDS = List.of(
            new Kind<>(Journey.class, JourneyEngine::of),
            new Kind<>(Encounter.class, EncounterEngine::of),
            new Kind<>(Crowd.class, CrowdEngine::of));

    /** A kind of task and what starts it. */
    private record Kind<T extends Task>(Class<T> type, BiFunction<Scene, T, Engine> starter) {
        Engine start(Scene scene, Task task) {
            return starter.apply(scene, type.cast(task));
        }
    }

    private Tasks() {}

    /**
     * Starts a task. Nothing is computed before the engine's first step.
     *
     * @throws IllegalArgumentException if the scene has no such task
     */
    public static Engine start(Scene scene, String id) {
        Task task = scene.task(id)
                .orElseThrow(
                        () -> new IllegalArgumentException("unknown task '" + id + "'; the scene has " + ids(scene)));
        for (Kind<?> kind : KINDS) {
            if (kind.type().isInstance(task)) {
                return kind.start(scene, task);
            }
        }
        throw new IllegalStateException("no planner is registered for tasks of kind " + task.kind());
    }

    /**
     * Starts the task of a saved run again, with all that was given from outside while it ran.
     *
     * @throws RunException if the run's inputs do not fit its task
     */
    public static Engine again(Run saved) throws RunException {
        Engine engine = start(saved.scene(), saved.task());
        for (Run.Input input : saved.inputs()) {
            give(engine, input);
        }
        return engine;
    }

    private static void give(Engine engine, Run.Input input) throws RunException {
        if (!(engine instanceof Simulation simulation)) {
            throw new RunException("input '" + input.key() + "' of step " + input.step() + ": the task takes no input");
        }
        try {
            simulation.give(input);
        } catch (IllegalArgumentException e) {
            throw new RunException("input '" + input.key() + "' of step " + input.step() + ": " + e.getMessage(), e);
        }
    }

    /** Returns the ids of a scene's tasks in document order, comma-separated, or "none". */
    public static String ids(Scene scene) {
        return scene.tasks().isEmpty()
                ? "none"
                : String.join(", ", scene.tasks().stream().map(Task::id).toList());
    }
}
