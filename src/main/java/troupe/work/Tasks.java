package troupe.work;

import java.util.List;
import troupe.crowd.CrowdEngine;
import troupe.grid.region.Groundworks;
import troupe.risk.EncounterEngine;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.run.file.RunException;
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
            new Kind<>(Encounter.class, (scene, task, kept) -> EncounterEngine.of(scene, task)),
            new Kind<>(Crowd.class, (scene, task, kept) -> CrowdEngine.of(scene, task)));

    /** A kind of task and what starts it. */
    private record Kind<T extends Task>(Class<T> type, Starter<T> starter) {
        Engine start(Scene scene, Task task, Groundworks kept) {
            return starter.start(scene, type.cast(task), kept);
        }
    }

    /** Starts tasks of one kind. */
    private interface Starter<T extends Task> {
        Engine start(Scene scene, T task, Groundworks kept);
    }

    private Tasks() {}

    /**
     * Starts a task. Nothing is computed before the engine's first step.
     *
     * @throws IllegalArgumentException if the scene has no such task
     */
    public static Engine start(Scene scene, String id) {
        return start(scene, id, new Groundworks());
    }

    /**
     * Starts a task that shares what tasks started before have made of the same scene with its movable obstacles
     * elsewhere: while one is dragged, this saves a part of each plan. The result is the same. Nothing is computed before the
     * engine's first step.
     *
     * @param kept what the tasks that were given it have made
     * @throws IllegalArgumentException if the scene has no such task
     */
    public static Engine start(Scene scene, String id, Groundworks kept) {
        Task task = scene.task(id)
                .orElseThrow(
                        () -> new IllegalArgumentException("unknown task '" + id + "'; the scene has " + ids(scene)));
        for (Kind<?> kind : KINDS) {
            if (kind.type().isInstance(task)) {
                return kind.start(scene, task, kept);
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
