package troupe.scene;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * Changes a scene by dotted keys that mirror its file: {@code ordering=paper}, {@code preference.vault=off},
 * {@code walk.radius=0.3}, {@code start=2.9,0.9}. A key speaks of the given task and of its actor.
 */
public final class Settings {
    /** Makes a changed scene of a scene, a journey in it, and the value as text. */
    @FunctionalInterface
    private interface Setter {
        Scene set(Scene scene, Journey journey, String value);
    }

    /** Tells the value of a key as text, empty where it has none. */
    @FunctionalInterface
    private interface Getter {
        Optional<String> get(Scene scene, Journey journey);
    }

    private record Key(Getter getter, Setter setter) {}

    private static final Map<String, Key> KEYS = table();

    private Settings() {}

    /** Returns every known key, in the order in which help lists them. */
    public static List<String> keys() {
        return List.copyOf(KEYS.keySet());
    }

    /**
     * Returns the scene with one setting of a task changed.
     *
     * @throws IllegalArgumentException if the task or the key is unknown (the message lists those there
     *     are), or the value cannot be read or is out of range
     */
    public static Scene apply(Scene scene, String taskId, String key, String value) {
        Key known = KEYS.get(key);
        if (known == null) {
            throw new IllegalArgumentException(
                    "unknown setting '" + key + "'; known are " + String.join(", ", KEYS.keySet()));
        }
        Journey journey = journey(scene, taskId);
        try {
            return known.setter().set(scene, journey, value);
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
        Journey journey = journey(scene, taskId);
        Map<String, String> values = new LinkedHashMap<>();
        KEYS.forEach((name, key) -> key.getter().get(scene, journey).ifPresent(value -> values.put(name, value)));
        return values;
    }

    private static Journey journey(Scene scene, String taskId) {
        Task task = scene.task(taskId)
                .orElseThrow(() -> new IllegalArgumentException("no task '" + taskId + "'; the scene has "
                        + String.join(", ", scene.tasks().stream().map(Task::id).toList())));
        if (task instanceof Journey journey) {
            return journey;
        }
        throw new IllegalArgumentException("task '" + taskId + "' is a " + task.kind() + "; needs a journey");
    }

    private static Map<String, Key> table() {
        Map<String, Key> all = new LinkedHashMap<>();
        all.put("ordering", journey(j -> Orderings.text(j.ordering()), (j, v) -> j.with(Orderings.ordering(v))));
        all.put(
                "spread",
                journey(
                        j -> j.spread().name().toLowerCase(Locale.ROOT),
                        (j, v) -> j.with(word(Journey.Spread.class, v))));
        all.put(
                "manipulation",
                journey(
                        j -> j.manipulation().name().toLowerCase(Locale.ROOT),
                        (j, v) -> j.with(word(Journey.Manipulation.class, v))));
        all.put(
                "headings",
                journey(
                        j -> Integer.toString(j.headings()),
                        (j, v) -> j.withHeadings((int) positive(v, Journey.MOST_HEADINGS))));
        all.put(
                "slice",
                journey(
                        j -> Integer.toString(j.slice()),
                        (j, v) -> j.limited(positive(v, Integer.MAX_VALUE), j.expansions())));
        all.put(
                "limit.expansions",
                journey(
                        j -> Long.toString(j.expansions()),
                        (j, v) -> j.limited(j.slice(), positive(v, Long.MAX_VALUE))));
        all.put("seed", journey(j -> Long.toString(j.seed()), (j, v) -> j.seeded(Numbers.whole(v))));
        all.put("start", journey(j -> Numbers.text(j.start()), (j, v) -> j.between(Numbers.place(v), j.goal())));
        all.put("goal", journey(j -> Numbers.text(j.goal()), (j, v) -> j.between(j.start(), Numbers.place(v))));
        for (Ability ability : Ability.values()) {
            all.put("preference." + ability.key(), preference(ability));
        }
        for (String name : ActorForm.BODY) {
            all.put(name, body(name));
        }
        for (Ability ability : Ability.values()) {
            for (String name : ActorForm.names(ability)) {
                all.put(ability.key() + "." + name, number(ability, name));
            }
        }
        all.put("cell", cell());
        return all;
    }

    private static Key journey(Function<Journey, String> value, BiFunction<Journey, String, Journey> change) {
        return new Key(
                (scene, journey) -> Optional.of(value.apply(journey)),
                (scene, journey, text) -> scene.with(change.apply(journey, text)));
    }

    private static Key preference(Ability ability) {
        return journey(
                j -> Orderings.factor(j.preferences().of(ability)),
                (j, v) -> j.preferring(j.preferences().with(ability, Orderings.factor(v))));
    }

    private static Key body(String name) {
        return new Key(
                (scene, journey) -> scene.actor(journey.actor())
                        .map(actor -> Numbers.text(ActorForm.of(actor).body(name))),
                (scene, journey, value) -> withActor(scene, journey, form -> form.setBody(name, finite(value))));
    }

    private static Key number(Ability ability, String name) {
        return new Key(
                (scene, journey) -> scene.actor(journey.actor())
                        .map(ActorForm::of)
                        .filter(form -> form.has(ability))
                        .map(form -> Numbers.text(form.number(ability, name))),
                (scene, journey, value) -> withActor(scene, journey, form -> {
                    if (!form.has(ability)) {
                        throw new IllegalArgumentException(
                                "the actor '" + journey.actor() + "' cannot " + ability.key());
                    }
                    form.set(ability, name, finite(value));
                }));
    }

    private static Key cell() {
        return new Key(
                (scene, journey) -> Optional.of(Numbers.text(scene.world().cell())),
                (scene, journey, value) -> scene.with(
                        new World(scene.world().width(), scene.world().depth(), finite(value))));
    }

    private static Scene withActor(Scene scene, Journey journey, java.util.function.Consumer<ActorForm> change) {
        Actor actor = scene.actor(journey.actor())
                .orElseThrow(() -> new IllegalArgumentException("the scene has no actor '" + journey.actor() + "'"));
        ActorForm form = ActorForm.of(actor);
        change.accept(form);
        return scene.with(form.actor(actor.id(), actor.label(), actor.colour()));
    }

    private static <E extends Enum<E>> E word(Class<E> type, String value) {
        List<String> words = new ArrayList<>();
        for (E constant : type.getEnumConstants()) {
            String word = constant.name().toLowerCase(Locale.ROOT);
            if (word.equals(value.strip())) {
                return constant;
            }
            words.add(word);
        }
        throw new IllegalArgumentException("needs " + String.join(" or ", words));
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
