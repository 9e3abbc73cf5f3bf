package troupe.app.property;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import troupe.app.document.SceneEdits;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.setting.Settings;

/**
 * Lists the properties of tasks: those of a journey with its places as numbers and its actor to choose, and the
 * settings of any other kind as files know them.
 */
final class TaskProperties {
    private static final Map<String, List<String>> CHOICES = Map.of(
            "ordering", List.of("optimal", "paper"),
            "spread", words(Journey.Spread.values()),
            "method", words(Encounter.Method.values()),
            "influence", words(Encounter.Influence.values()),
            "growth", words(Encounter.Growth.values()),
            "motion", words(Crowd.Motion.values()),
            "split", words(Crowd.Split.values()));

    /** Some bounds for the ordering of journeys; others stand in files. */
    private static final List<String> BOUNDS = List.of("bounded(1.5)", "bounded(2)", "bounded(3)");

    private static final Pattern RELATION = Pattern.compile("(relation\\.\\d+)\\..*");

    /** Settings that stand with the places of the task, or with the preferences of its actor. */
    private static final List<String> ELSEWHERE = List.of("start", "goal", "manipulation", "headings");

    private TaskProperties() {}

    private static List<String> words(Enum<?>[] values) {
        return Stream.of(values).map(v -> v.name().toLowerCase(Locale.ROOT)).toList();
    }

    /** Returns the groups: the task itself, its weights, and its relations, one group for each depth. */
    static List<Group> groups(Scene scene, Task task) {
        Map<String, List<Property>> groups = new LinkedHashMap<>();
        for (Property property : of(scene, task)) {
            String key = property.key().replaceFirst("^setting\\.", "");
            Matcher relation = RELATION.matcher(key);
            String group = relation.matches() ? relation.group(1) : key.startsWith("weight.") ? "weight" : "";
            groups.computeIfAbsent(group, k -> new ArrayList<>()).add(property);
        }
        return groups.entrySet().stream()
                .map(e -> new Group(e.getKey(), e.getValue()))
                .toList();
    }

    static List<Property> of(Scene scene, Task task) {
        List<Property> all = new ArrayList<>();
        if (!(task instanceof Crowd)) {
            all.add(actor(scene));
            for (boolean start : new boolean[] {true, false}) {
                all.add(coordinate(start, "x"));
                all.add(coordinate(start, "y"));
                all.add(elevation(start));
            }
        }
        for (String key : Settings.values(scene, task.id()).keySet()) {
            boolean elsewhere = key.equals("cell")
                    || ActorProperties.isOfActor(key)
                    || key.startsWith("preference.")
                    || ELSEWHERE.contains(key);
            if (!elsewhere) {
                all.add(setting(key, choices(scene, task, key)));
            }
        }
        return all;
    }

    /** Returns what there is to choose from for a setting; none where anything may be typed. */
    private static List<String> choices(Scene scene, Task task, String key) {
        List<String> all = new ArrayList<>(CHOICES.getOrDefault(key, List.of()));
        if (key.equals("ordering") && task instanceof Journey) {
            all.addAll(BOUNDS);
        }
        String present = Settings.values(scene, task.id()).get(key);
        if (!all.isEmpty() && !all.contains(present)) {
            all.add(present);
        }
        return all;
    }

    /** Makes the property of a setting of tasks. */
    private static Property setting(String key, List<String> choices) {
        return new Property(
                "setting." + key,
                "setting." + key,
                ActorProperties.unit(key),
                choices,
                (scene, id) ->
                        scene.task(id).map(t -> Settings.values(scene, id).get(key)),
                (scene, id, text) -> Settings.apply(scene, id, key, text.strip().replace('\u2212', '-')));
    }

    private static Optional<Place> place(Scene scene, String id, boolean start) {
        Task task = scene.task(id).orElse(null);
        if (task instanceof Journey j) {
            return Optional.of(start ? j.start() : j.goal());
        }
        return task instanceof Encounter e ? Optional.of(start ? e.start() : e.goal()) : Optional.empty();
    }

    private static Scene with(Scene scene, String id, boolean start, Place place) {
        return start ? SceneEdits.startingAt(scene, id, place) : SceneEdits.endingAt(scene, id, place);
    }

    private static String end(boolean start) {
        return start ? "start" : "goal";
    }

    private static Property coordinate(boolean start, String axis) {
        return new Property(
                end(start) + "." + axis,
                end(start),
                "m",
                List.of(),
                (scene, id) -> place(scene, id, start).map(p -> Typed.text(axis.equals("x") ? p.x() : p.y(), 2)),
                (scene, id, text) -> {
                    double v = Typed.number(text, Typed.ANY);
                    Place p = place(scene, id, start).orElseThrow();
                    return with(
                            scene,
                            id,
                            start,
                            axis.equals("x") ? new Place(v, p.y(), p.z()) : new Place(p.x(), v, p.z()));
                });
    }

    private static Property elevation(boolean start) {
        return Property.typed(
                end(start) + ".z",
                "m",
                (scene, id) ->
                        place(scene, id, start).map(p -> p.z().isPresent() ? Typed.text(p.z().getAsDouble(), 2) : ""),
                (scene, id, text) -> {
                    Place p = place(scene, id, start).orElseThrow();
                    OptionalDouble z =
                            text.isBlank() ? OptionalDouble.empty() : OptionalDouble.of(Typed.number(text, Typed.ANY));
                    return with(scene, id, start, new Place(p.x(), p.y(), z));
                });
    }

    private static Property actor(Scene scene) {
        List<String> ids = scene.actors().stream().map(a -> a.id()).toList();
        return new Property(
                "actor",
                "actor",
                "",
                ids,
                (now, id) -> now.task(id)
                        .map(t -> t instanceof Journey j ? j.actor() : t instanceof Encounter e ? e.actor() : null),
                (now, id, text) -> acted(now, now.task(id).orElseThrow(), text));
    }

    private static Scene acted(Scene scene, Task task, String actor) {
        if (task instanceof Journey journey) {
            return scene.with(journey.withActor(actor));
        }
        return task instanceof Encounter encounter ? scene.with(encounter.withActor(actor)) : scene;
    }
}
