package troupe.scene;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiFunction;

/**
 * Changes a scene by dotted keys that mirror its file: {@code ordering=paper}, {@code preference.vault=off},
 * {@code walk.radius=0.3}, {@code start=2.9,0.9}. A key speaks of the given task and of its actor.
 */
public final class Settings {
    /** Makes a changed scene of a scene, the id of a journey in it, and the value as text. */
    @FunctionalInterface
    private interface Setter {
        Scene set(Scene scene, Journey journey, String value);
    }

    private static final Map<String, Setter> SETTERS = setters();

    private Settings() {}

    /** Returns every known key, in the order in which help lists them. */
    public static List<String> keys() {
        return List.copyOf(SETTERS.keySet());
    }

    /**
     * Returns the scene with one setting of a task changed.
     *
     * @throws IllegalArgumentException if the task or the key is unknown (the message lists those there
     *     are), or the value cannot be read or is out of range
     */
    public static Scene apply(Scene scene, String taskId, String key, String value) {
        Setter setter = SETTERS.get(key);
        if (setter == null) {
            throw new IllegalArgumentException(
                    "unknown setting '" + key + "'; known are " + String.join(", ", SETTERS.keySet()));
        }
        Task task = scene.task(taskId)
                .orElseThrow(() -> new IllegalArgumentException("no task '" + taskId + "'; the scene has "
                        + String.join(", ", scene.tasks().stream().map(Task::id).toList())));
        if (!(task instanceof Journey journey)) {
            throw new IllegalArgumentException(
                    "task '" + taskId + "' is a " + task.kind() + "; '" + key + "' is a setting of a journey");
        }
        try {
            return setter.set(scene, journey, value);
        } catch (IllegalArgumentException | ArithmeticException e) {
            throw new IllegalArgumentException(key + "=" + value + ": " + e.getMessage(), e);
        }
    }

    private static Map<String, Setter> setters() {
        Map<String, Setter> all = new LinkedHashMap<>();
        all.put("ordering", journey((j, v) -> j.with(Orderings.ordering(v))));
        all.put("spread", journey((j, v) -> j.with(spread(v))));
        all.put("slice", journey((j, v) -> j.limited(positive(v, Integer.MAX_VALUE), j.expansions())));
        all.put("limit.expansions", journey((j, v) -> j.limited(j.slice(), positive(v, Long.MAX_VALUE))));
        all.put("seed", journey((j, v) -> j.seeded(Numbers.whole(v))));
        all.put("start", journey((j, v) -> j.between(Numbers.place(v), j.goal())));
        all.put("goal", journey((j, v) -> j.between(j.start(), Numbers.place(v))));
        for (Ability ability : Ability.values()) {
            all.put(
                    "preference." + ability.key(),
                    journey((j, v) -> j.preferring(j.preferences().with(ability, Orderings.factor(v)))));
        }
        for (String name : ActorForm.BODY) {
            all.put(
                    name,
                    (scene, journey, value) -> withActor(scene, journey, form -> form.setBody(name, finite(value))));
        }
        for (Ability ability : Ability.values()) {
            for (String name : ActorForm.names(ability)) {
                all.put(
                        ability.key() + "." + name,
                        (scene, journey, value) -> withActor(scene, journey, form -> {
                            if (!form.has(ability)) {
                                throw new IllegalArgumentException(
                                        "the actor '" + journey.actor() + "' cannot " + ability.key());
                            }
                            form.set(ability, name, finite(value));
                        }));
            }
        }
        all.put(
                "cell",
                (scene, journey, value) -> scene.with(
                        new World(scene.world().width(), scene.world().depth(), finite(value))));
        return all;
    }

    private static Setter journey(BiFunction<Journey, String, Journey> change) {
        return (scene, journey, value) -> scene.with(change.apply(journey, value));
    }

    private static Scene withActor(Scene scene, Journey journey, java.util.function.Consumer<ActorForm> change) {
        Actor actor = scene.actor(journey.actor())
                .orElseThrow(() -> new IllegalArgumentException("the scene has no actor '" + journey.actor() + "'"));
        ActorForm form = ActorForm.of(actor);
        change.accept(form);
        return scene.with(form.actor(actor.id(), actor.label(), actor.colour()));
    }

    private static Journey.Spread spread(String value) {
        for (Journey.Spread spread : Journey.Spread.values()) {
            if (spread.name().toLowerCase(Locale.ROOT).equals(value.strip())) {
                return spread;
            }
        }
        throw new IllegalArgumentException("needs breadth or clearance");
    }

    private static long positive(String value, long most) {
        long number = Numbers.whole(value);
        if (number < 1 || number > most) {
            throw new IllegalArgumentException("needs a whole number from 1 to " + most);
        }
        return number;
    }

    private static double finite(String value) {
        double number = Numbers.number(value);
        if (!Double.isFinite(number)) {
            throw new IllegalArgumentException("needs a finite number");
        }
        return number;
    }
}
