package troupe.app.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiFunction;
import java.util.function.DoublePredicate;
import java.util.function.Function;
import java.util.stream.Collectors;
import troupe.app.document.CrowdEdits;
import troupe.app.document.Mark;
import troupe.app.document.Parts;
import troupe.scene.Avatar;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Lists the properties of the parts of tasks: avatars and groups. */
final class PartProperties {
    private static final String COLOUR = "#[0-9a-fA-F]{6}|";
    private static final DoublePredicate WHOLE = v -> v >= 1 && v == Math.rint(v) && v <= 100_000;

    private PartProperties() {}

    /** Lists the properties of an avatar. */
    static List<Property> avatar(Avatar avatar) {
        List<Property> all = new ArrayList<>();
        all.add(new Property(
                "avatar.kind",
                "avatar.kind",
                "",
                List.of("uncertain", "certain"),
                (scene, id) -> Parts.avatar(scene, id).map(a -> a.kind().name().toLowerCase(Locale.ROOT)),
                (scene, id, text) ->
                        Parts.withAvatar(scene, id, a -> a.as(Avatar.Kind.valueOf(text.toUpperCase(Locale.ROOT))))));
        all.add(motion(avatar));
        all.add(coordinate("avatar.x", true));
        all.add(coordinate("avatar.y", false));
        all.add(way());
        all.add(pace());
        all.add(number("radius", "m", Typed.POSITIVE, Avatar::radius, (a, v) -> body(a, v, a.speed(), a.mobility())));
        all.add(number("speed", "m/s", Typed.POSITIVE, Avatar::speed, (a, v) -> body(a, a.radius(), v, a.mobility())));
        all.add(number(
                "mobility", "", Typed.NOT_NEGATIVE, Avatar::mobility, (a, v) -> body(a, a.radius(), a.speed(), v)));
        all.add(Property.typed(
                "colour", "", (scene, id) -> Parts.avatar(scene, id).map(Avatar::colour), (scene, id, text) -> {
                    String colour = colour(text);
                    return Parts.withAvatar(
                            scene,
                            id,
                            a -> new Avatar(
                                    a.id(),
                                    a.label(),
                                    colour,
                                    a.radius(),
                                    a.speed(),
                                    a.mobility(),
                                    a.kind(),
                                    a.motion()));
                }));
        return all;
    }

    private static Avatar body(Avatar a, double radius, double speed, double mobility) {
        return new Avatar(a.id(), a.label(), a.colour(), radius, speed, mobility, a.kind(), a.motion());
    }

    private static Property number(
            String key,
            String unit,
            DoublePredicate allowed,
            Function<Avatar, Double> get,
            BiFunction<Avatar, Double, Avatar> set) {
        return Property.typed(
                "avatar." + key,
                unit,
                (scene, id) -> Parts.avatar(scene, id).map(a -> Typed.text(get.apply(a), 2)),
                (scene, id, text) -> {
                    double value = Typed.number(text, allowed);
                    return Parts.withAvatar(scene, id, a -> set.apply(a, value));
                });
    }

    private static Property motion(Avatar avatar) {
        boolean recorded = avatar.motion() instanceof Avatar.Recording;
        return new Property(
                "avatar.motion",
                "avatar.motion",
                "",
                recorded ? List.of("recording") : List.of("pointer", "script"),
                (scene, id) -> Parts.avatar(scene, id)
                        .map(a -> a.motion() instanceof Avatar.Pointer
                                ? "pointer"
                                : a.motion() instanceof Avatar.Script ? "script" : "recording"),
                (scene, id, text) -> Parts.withAvatar(scene, id, a -> moving(a, text)));
    }

    private static Avatar moving(Avatar avatar, String kind) {
        Optional<Place> start = Mark.start(avatar);
        if (start.isEmpty() || kind.equals("script") == avatar.motion() instanceof Avatar.Script) {
            return avatar;
        }
        return Mark.moving(
                avatar,
                kind.equals("script")
                        ? new Avatar.Script(start.get(), Avatar.DEFAULT_PACE, List.of())
                        : new Avatar.Pointer(start.get()));
    }

    private static Property coordinate(String key, boolean x) {
        return new Property(
                key,
                "position",
                "m",
                List.of(),
                (scene, id) -> Parts.avatar(scene, id).flatMap(Mark::start).map(p -> Typed.text(x ? p.x() : p.y(), 2)),
                (scene, id, text) -> {
                    double v = Typed.number(text, Typed.ANY);
                    return Parts.withAvatar(scene, id, a -> {
                        Place p = Mark.start(a).orElseThrow();
                        return Mark.starting(a, x ? new Place(v, p.y(), p.z()) : new Place(p.x(), v, p.z()));
                    });
                });
    }

    /** The goals of a script as {@code x, y; x, y @ seconds}. */
    private static Property way() {
        return Property.typed(
                "avatar.way",
                "",
                (scene, id) -> Parts.avatar(scene, id)
                        .filter(a -> a.motion() instanceof Avatar.Script)
                        .map(a ->
                                Mark.heads(a).stream().map(PartProperties::text).collect(Collectors.joining("; "))),
                (scene, id, text) -> {
                    List<Avatar.Head> heads = new ArrayList<>();
                    for (String part : text.split(";")) {
                        if (!part.isBlank()) {
                            heads.add(head(part));
                        }
                    }
                    return Parts.withAvatar(scene, id, a -> {
                        Avatar.Script script = (Avatar.Script) a.motion();
                        return Mark.moving(a, new Avatar.Script(script.start(), script.pace(), heads));
                    });
                });
    }

    private static String text(Avatar.Head head) {
        String place =
                Typed.text(head.to().x(), 2) + ", " + Typed.text(head.to().y(), 2);
        return head.at().isPresent() ? place + " @ " + Typed.text(head.at().getAsDouble(), 2) : place;
    }

    private static Avatar.Head head(String text) {
        String[] timed = text.split("@", -1);
        String[] xy = timed[0].split(",", -1);
        if (timed.length > 2 || xy.length != 2) {
            throw new IllegalArgumentException("'" + text.strip() + "': x, y @ s");
        }
        return new Avatar.Head(
                Place.of(Typed.number(xy[0], Typed.ANY), Typed.number(xy[1], Typed.ANY)),
                timed.length == 1
                        ? OptionalDouble.empty()
                        : OptionalDouble.of(Typed.number(timed[1], Typed.NOT_NEGATIVE)));
    }

    private static Property pace() {
        return Property.typed(
                "avatar.pace",
                "m/s",
                (scene, id) -> Parts.avatar(scene, id)
                        .map(a -> a.motion() instanceof Avatar.Script s ? Typed.text(s.pace(), 2) : null),
                (scene, id, text) -> {
                    double pace = Typed.number(text, Typed.POSITIVE);
                    return Parts.withAvatar(scene, id, a -> {
                        Avatar.Script script = (Avatar.Script) a.motion();
                        return Mark.moving(a, new Avatar.Script(script.start(), pace, script.heads()));
                    });
                });
    }

    /** Lists the properties of a group. */
    static List<Property> group() {
        List<Property> all = new ArrayList<>();
        all.add(members(
                "count",
                "",
                WHOLE,
                m -> Typed.text(m.count(), 0),
                (m, v) -> new CrowdGroup.Members(v.intValue(), m.spawn(), m.floor(), m.radius(), m.speed())));
        all.add(goal("group.goal.x", true));
        all.add(goal("group.goal.y", false));
        all.addAll(ShapeProperties.placing());
        all.add(members(
                "radius",
                "m",
                Typed.POSITIVE,
                m -> Typed.text(m.radius(), 2),
                (m, v) -> new CrowdGroup.Members(m.count(), m.spawn(), m.floor(), v, m.speed())));
        all.add(members(
                "speed",
                "m/s",
                Typed.POSITIVE,
                m -> Typed.text(m.speed(), 2),
                (m, v) -> new CrowdGroup.Members(m.count(), m.spawn(), m.floor(), m.radius(), v)));
        all.add(floor());
        all.add(Property.typed(
                "colour", "", (scene, id) -> Parts.group(scene, id).map(CrowdGroup::colour), (scene, id, text) -> {
                    String colour = colour(text);
                    return Parts.withGroup(
                            scene,
                            id,
                            g -> new CrowdGroup(g.id(), g.label(), colour, g.goal(), g.members(), g.parts()));
                }));
        return all;
    }

    private static Property members(
            String key,
            String unit,
            DoublePredicate allowed,
            Function<CrowdGroup.Members, String> get,
            BiFunction<CrowdGroup.Members, Double, CrowdGroup.Members> set) {
        return Property.typed(
                "group." + key,
                unit,
                (scene, id) ->
                        Parts.group(scene, id).flatMap(CrowdGroup::members).map(get),
                (scene, id, text) -> {
                    double value = Typed.number(text, allowed);
                    return Parts.withMembers(scene, id, m -> set.apply(m, value));
                });
    }

    /** A coordinate of the goal; emptied, the group goes where the one above it goes. */
    private static Property goal(String key, boolean x) {
        return new Property(
                key,
                "goal",
                "m",
                List.of(),
                (scene, id) -> Parts.group(scene, id).map(g -> g.goal()
                        .map(p -> Typed.text(x ? p.x() : p.y(), 2))
                        .orElse("")),
                (scene, id, text) -> {
                    if (text.isBlank()) {
                        return Parts.withGroup(scene, id, g -> CrowdEdits.going(g, Optional.empty()));
                    }
                    double v = Typed.number(text, Typed.ANY);
                    return Parts.withGroup(scene, id, g -> {
                        Place p = g.goal().orElse(middle(scene));
                        Place to = x ? new Place(v, p.y(), p.z()) : new Place(p.x(), v, p.z());
                        return CrowdEdits.going(g, Optional.of(to));
                    });
                });
    }

    private static Place middle(Scene scene) {
        return Place.of(scene.world().width() / 2, scene.world().depth() / 2);
    }

    private static Property floor() {
        return Property.typed(
                "group.floor",
                "m",
                (scene, id) -> Parts.group(scene, id)
                        .flatMap(CrowdGroup::members)
                        .map(m -> m.floor().isPresent() ? Typed.text(m.floor().getAsDouble(), 2) : ""),
                (scene, id, text) -> {
                    OptionalDouble floor =
                            text.isBlank() ? OptionalDouble.empty() : OptionalDouble.of(Typed.number(text, Typed.ANY));
                    return Parts.withMembers(
                            scene, id, m -> new CrowdGroup.Members(m.count(), m.spawn(), floor, m.radius(), m.speed()));
                });
    }

    private static String colour(String text) {
        if (!text.strip().matches(COLOUR)) {
            throw new IllegalArgumentException("'" + text + "': #rrggbb");
        }
        return text.strip();
    }
}
