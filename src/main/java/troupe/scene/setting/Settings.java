package troupe.scene.setting;

import java.util.List;
import java.util.Map;
import troupe.scene.Crowd;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Changes a scene by dotted keys that mirror its file: {@code ordering=paper}, {@code preference.vault=off},
 * {@code walk.radius=0.3}, {@code start=2.9,0.9}. A key speaks of the given task and of its actor; each kind of
 * task has keys of its own.
 */
public final class Settings {
    private static final List<SettingTable<?>> TABLES = List.of(TaskSettings.journey(), TaskSettings.encounter());

    private Settings() {}

    /** Returns every key that a task knows, in the order in which help lists them. */
    public static List<String> keys(Task task) {
        return table(task).keys();
    }

    /**
     * Returns the scene with one setting of a task changed.
     *
     * @throws IllegalArgumentException if the task or the key is unknown (the message lists those there
     *     are), or the value cannot be read or is out of range
     */
    public static Scene apply(Scene scene, String taskId, String key, String value) {
        Task task = task(scene, taskId);
        SettingTable<?> table = table(task);
        if (!table.keys().contains(key)) {
            throw new IllegalArgumentException(
                    "unknown setting '" + key + "'; known are " + String.join(", ", table.keys()));
        }
        try {
            return table.apply(scene, task, key, value);
        } catch (IllegalArgumentException | ArithmeticException e) {
            String setting = key + "=" + value;
            String reason = String.valueOf(e.getMessage());
            throw new IllegalArgumentException(reason.startsWith(setting) ? reason : setting + ": " + reason, e);
        }
    }

    /**
     * Returns the value of every key of a task that has one, as text that {@link #apply} takes, in the order of
     * {@link #keys}.
     *
     * @throws IllegalArgumentException if the task is unknown
     */
    public static Map<String, String> values(Scene scene, String taskId) {
        Task task = task(scene, taskId);
        return table(task).values(scene, task);
    }

    private static Task task(Scene scene, String taskId) {
        return scene.task(taskId)
                .orElseThrow(() -> new IllegalArgumentException("no task '" + taskId + "'; the scene has "
                        + String.join(", ", scene.tasks().stream().map(Task::id).toList())));
    }

    private static SettingTable<?> table(Task task) {
        if (task instanceof Crowd crowd) {
            return CrowdSettings.table(crowd);
        }
        return TABLES.stream()
                .filter(table -> table.takes(task))
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("no settings are known of a " + task.kind()));
    }
}
