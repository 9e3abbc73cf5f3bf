package troupe.app.property;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import troupe.app.document.NewElements;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.setting.Settings;

/** Lists the properties of actors: the body, and each ability with its numbers and whether there is one. */
final class ActorProperties {
    private static final String ID = "journey-of-actor";

    private static final int LONG = 10;

    private ActorProperties() {}

    /** Tells whether a setting speaks of an actor. */
    static boolean isOfActor(String key) {
        boolean body =
                List.of("bodyHeight", "footRadius", "stepHeight", "maxBorder").contains(key);
        return body || Arrays.stream(Ability.values()).anyMatch(a -> key.startsWith(a.key() + "."));
    }

    /** Returns the unit of a setting, empty for one without. */
    static String unit(String key) {
        String name = key.substring(key.lastIndexOf('.') + 1);
        return switch (name) {
            case "energy" -> key.startsWith("move") ? "J/m kg" : "J/m";
            case "turnEnergy" -> "J/rad kg";
            case "takeOff" -> "J";
            case "speed" -> "m/s";
            case "sigma", "trade", "view" -> "m";
            case "horizon", "duration", "seconds" -> "s";
            case "rate" -> "1/s";
            default -> isOfActor(key) ? "m" : "";
        };
    }

    /** Lists the groups: the body, then one for each ability. */
    static List<Group> of(Scene scene, Actor actor) {
        List<Group> groups = new ArrayList<>();
        Map<String, String> values = values(scene, actor);
        groups.add(new Group("body", settings(values, key -> key.indexOf('.') < 0)));
        for (Ability ability : Ability.values()) {
            List<Property> properties = new ArrayList<>();
            if (ability != Ability.WALK) {
                properties.add(has(ability));
            }
            properties.addAll(settings(values, key -> key.startsWith(ability.key() + ".")));
            groups.add(new Group("ability." + ability.key(), properties));
        }
        return groups;
    }

    private static List<Property> settings(Map<String, String> values, java.util.function.Predicate<String> wanted) {
        return values.keySet().stream()
                .filter(key -> isOfActor(key) && wanted.test(key))
                .map(ActorProperties::setting)
                .toList();
    }

    /** Settings speak of the actor of a task, so an actor is asked about in a scene where it has one. */
    private static Scene acting(Scene scene, Actor actor) {
        return NewElements.with(scene, Journey.of(ID, actor.id(), Place.of(0, 0), Place.of(0, 0)));
    }

    private static Map<String, String> values(Scene scene, Actor actor) {
        return Settings.values(acting(scene, actor), ID);
    }

    private static Property setting(String key) {
        return Property.typed(
                "setting." + key,
                unit(key),
                (scene, id) ->
                        scene.actor(id).map(a -> values(scene, a).get(key)).map(ActorProperties::brief),
                (scene, id, text) -> {
                    Actor actor = scene.actor(id).orElseThrow();
                    Scene changed = Settings.apply(acting(scene, actor), ID, key, Typed.plain(text));
                    return scene.with(changed.actor(id).orElseThrow());
                });
    }

    /** Returns a number without the digits that a product of decimals leaves. */
    private static String brief(String value) {
        return value.length() <= LONG ? value : String.valueOf(Math.rint(Double.parseDouble(value) * 1e6) / 1e6);
    }

    private static Property has(Ability ability) {
        return new Property(
                "has." + ability.key(),
                "has",
                "",
                Property.SWITCH,
                (scene, id) ->
                        scene.actor(id).map(a -> Boolean.toString(a.abilities().contains(ability))),
                (scene, id, text) -> {
                    Actor actor = scene.actor(id).orElseThrow();
                    return scene.with(
                            Boolean.parseBoolean(text) ? with(actor, ability) : actor.without(Set.of(ability)));
                });
    }

    private static Actor with(Actor a, Ability added) {
        return new Actor(
                a.id(),
                a.label(),
                a.colour(),
                a.bodyHeight(),
                a.footRadius(),
                a.stepHeight(),
                a.maxBorder(),
                a.walk(),
                added == Ability.SIDESTEP ? Optional.of(Actor.Sidestep.DEFAULT) : a.sidestep(),
                added == Ability.STRIDE ? Optional.of(Actor.Stride.DEFAULT) : a.stride(),
                added == Ability.VAULT ? Optional.of(Actor.Vault.DEFAULT) : a.vault(),
                added == Ability.MOVE ? Optional.of(Actor.Move.DEFAULT) : a.move());
    }
}
