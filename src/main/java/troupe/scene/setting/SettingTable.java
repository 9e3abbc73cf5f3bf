package troupe.scene.setting;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Numbers;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.World;

/** Holds the settings of one kind of task: by dotted key, how a value is told and how it is set. Immutable once filled. */
public final class SettingTable<T extends Task> {
    /** Makes a changed scene of a scene, a task in it, and the value as text. */
    @FunctionalInterface
    public interface Setter<T> {
        Scene set(Scene scene, T task, String value);
    }

    private record Key<T>(BiFunction<Scene, T, Optional<String>> getter, Setter<T> setter) {}

    private final Class<T> type;
    private final Function<T, String> actor;
    private final Map<String, Key<T>> keys = new LinkedHashMap<>();

    /** Makes an empty table of a kind of task that is of one actor. */
    public SettingTable(Class<T> type, Function<T, String> actor) {
        this.type = type;
        this.actor = actor;
    }

    /** Tells whether it is of the kind of a task. */
    public boolean takes(Task task) {
        return type.isInstance(task);
    }

    /** Returns the keys in the order of their adding. */
    public List<String> keys() {
        return List.copyOf(keys.keySet());
    }

    /** Sets one key of a task of this kind. */
    public Scene apply(Scene scene, Task task, String key, String value) {
        return keys.get(key).setter().set(scene, type.cast(task), value);
    }

    /** Returns the values of a task of this kind, by key, without those that have none. */
    public Map<String, String> values(Scene scene, Task task) {
        Map<String, String> values = new LinkedHashMap<>();
        keys.forEach(
                (name, key) -> key.getter().apply(scene, type.cast(task)).ifPresent(value -> values.put(name, value)));
        return values;
    }

    /** Adds a setting of the task itself. */
    public void task(String key, Function<T, String> value, BiFunction<T, String, T> change) {
        keys.put(
                key,
                new Key<>(
                        (scene, task) -> Optional.of(value.apply(task)),
                        (scene, task, text) -> scene.with(change.apply(task, text))));
    }

    /** Adds the numbers of the body of the task's actor, and of abilities: {@code walk.radius}, … */
    public void actor(Iterable<Ability> abilities) {
        for (String name : ActorForm.BODY) {
            keys.put(name, body(name));
        }
        for (Ability ability : abilities) {
            for (String name : ActorForm.names(ability)) {
                keys.put(ability.key() + "." + name, number(ability, name));
            }
        }
    }

    private Key<T> body(String name) {
        return new Key<>(
                (scene, task) -> scene.actor(actor.apply(task))
                        .map(found -> Numbers.text(ActorForm.of(found).body(name))),
                (scene, task, value) -> withActor(scene, task, form -> form.setBody(name, finite(value))));
    }

    private Key<T> number(Ability ability, String name) {
        return new Key<>(
                (scene, task) -> scene.actor(actor.apply(task))
                        .map(ActorForm::of)
                        .filter(form -> form.has(ability))
                        .map(form -> Numbers.text(form.number(ability, name))),
                (scene, task, value) -> withActor(scene, task, form -> {
                    if (!form.has(ability)) {
                        throw new IllegalArgumentException(
                                "the actor '" + actor.apply(task) + "' cannot " + ability.key());
                    }
                    form.set(ability, name, finite(value));
                }));
    }

    private Scene withActor(Scene scene, T task, Consumer<ActorForm> change) {
        String id = actor.apply(task);
        Actor found =
                scene.actor(id).orElseThrow(() -> new IllegalArgumentException("the scene has no actor '" + id + "'"));
        ActorForm form = ActorForm.of(found);
        change.accept(form);
        return scene.with(form.actor(found.id(), found.label(), found.colour()));
    }

    /** Adds the edge of a grid cell. */
    public void cell() {
        keys.put(
                "cell",
                new Key<>(
                        (scene, task) -> Optional.of(Numbers.text(scene.world().cell())),
                        (scene, task, value) -> scene.with(
                                new World(scene.world().width(), scene.world().depth(), finite(value)))));
    }

    /** Reads a constant by its word. */
    public static <E extends Enum<E>> E word(Class<E> type, String value) {
        List<String> words = new ArrayList<>();
        for (E constant : type.getEnumConstants()) {
            String word = word(constant);
            if (word.equals(value.strip())) {
                return constant;
            }
            words.add(word);
        }
        throw new IllegalArgumentException("needs " + String.join(" or ", words));
    }

    /** Returns the word for a constant. */
    public static String word(Enum<?> constant) {
        return constant.name().toLowerCase(java.util.Locale.ROOT);
    }

    /** Reads a whole number from 1 to {@code most}. */
    public static long positive(String value, long most) {
        long number = Numbers.whole(value);
        if (number < 1 || number > most) {
            throw new IllegalArgumentException("needs a whole number from 1 to " + most);
        }
        return number;
    }

    /** Reads a finite number. */
    public static double finite(String value) {
        double number = Numbers.number(value);
        if (!Double.isFinite(number)) {
            throw new IllegalArgumentException("needs a finite number");
        }
        return number;
    }
}
