package troupe.app.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.DoublePredicate;
import java.util.function.Function;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Lists the properties of obstacles and ditches. */
final class ShapeProperties {
    private static final String COLOUR = "#[0-9a-fA-F]{6}|";

    private ShapeProperties() {}

    /** Lists where an outline lies, how large it is, and how it is turned. */
    static List<Property> placing() {
        return List.of(
                position("x", "position", Point::x, (p, v) -> new Point(v, p.y())),
                position("y", "position", Point::y, (p, v) -> new Point(p.x(), v)),
                size("width", true),
                size("across", false),
                turn());
    }

    static List<Property> all() {
        List<Property> all = new ArrayList<>(placing());
        all.addAll(List.of(
                number(
                        "bottom",
                        "m",
                        2,
                        Typed.NOT_NEGATIVE,
                        Obstacle::offset,
                        (o, v) -> with(o, v, o.height(), o.movable(), o.mass(), o.colour())),
                number(
                        "height",
                        "m",
                        2,
                        Typed.POSITIVE,
                        Obstacle::height,
                        (o, v) -> with(o, o.offset(), v, o.movable(), o.mass(), o.colour())),
                depth(),
                mass(),
                movable(),
                colour()));
        return all;
    }

    private static Obstacle with(
            Obstacle o, double offset, double height, boolean movable, double mass, String colour) {
        return new Obstacle(o.id(), o.label(), o.outline(), offset, height, movable, mass, colour);
    }

    private static Optional<Polygon> outline(Scene scene, String id) {
        return SceneEdits.outline(scene, id);
    }

    private static Optional<Obstacle> obstacle(Scene scene, String id) {
        return scene.element(id).map(e -> e instanceof Obstacle o ? o : null);
    }

    private static Scene reshaped(Scene scene, String id, Function<Polygon, Polygon> change) {
        return SceneEdits.reshaped(scene, List.of(id), change::apply);
    }

    private static Property position(
            String key, String row, Function<Point, Double> get, BiFunction<Point, Double, Point> set) {
        return new Property(
                key,
                row,
                "m",
                List.of(),
                (scene, id) -> outline(scene, id).map(o -> Typed.text(get.apply(o.centroid()), 2)),
                (scene, id, text) -> reshaped(
                        scene, id, o -> SceneEdits.centred(o, set.apply(o.centroid(), Typed.number(text, Typed.ANY)))));
    }

    private static Property size(String key, boolean width) {
        Function<Polygon, Double> extent =
                o -> width ? o.bounds().width() : o.bounds().depth();
        return new Property(
                key,
                "size",
                "m",
                List.of(),
                (scene, id) -> outline(scene, id).map(o -> Typed.text(extent.apply(o), 2)),
                (scene, id, text) -> reshaped(scene, id, o -> {
                    double factor = Typed.number(text, Typed.POSITIVE) / extent.apply(o);
                    Point middle = o.centroid();
                    return troupe.app.document.Outlines.scaled(o, middle, width ? factor : 1, width ? 1 : factor);
                }));
    }

    private static Property turn() {
        return Property.typed(
                "turn", "\u00b0", (scene, id) -> outline(scene, id).map(o -> Texts.number(0, 1)), (scene, id, text) -> {
                    double rad = Math.toRadians(Typed.number(text, Typed.ANY));
                    return rad == 0 ? scene : reshaped(scene, id, o -> SceneEdits.turned(o, rad));
                });
    }

    private static Property number(
            String key,
            String unit,
            int decimals,
            DoublePredicate allowed,
            Function<Obstacle, Double> get,
            BiFunction<Obstacle, Double, Obstacle> set) {
        return Property.typed(
                key,
                unit,
                (scene, id) -> obstacle(scene, id).map(o -> Typed.text(get.apply(o), decimals)),
                (scene, id, text) ->
                        scene.with(set.apply(obstacle(scene, id).orElseThrow(), Typed.number(text, allowed))));
    }

    private static Property depth() {
        return Property.typed(
                "depth",
                "m",
                (scene, id) -> scene.element(id).map(e -> e instanceof Ditch d ? Typed.text(d.depth(), 2) : null),
                (scene, id, text) -> {
                    Ditch d = (Ditch) scene.element(id).orElseThrow();
                    return scene.with(new Ditch(d.id(), d.label(), d.outline(), Typed.number(text, Typed.POSITIVE)));
                });
    }

    private static Property mass() {
        Property all = number(
                "mass",
                "kg",
                1,
                Typed.POSITIVE,
                Obstacle::mass,
                (o, v) -> with(o, o.offset(), o.height(), o.movable(), v, o.colour()));
        return Property.typed(
                all.key(),
                all.unit(),
                (scene, id) -> obstacle(scene, id).filter(Obstacle::movable).flatMap(o -> all.reading()
                        .of(scene, id)),
                all.writing());
    }

    private static Property movable() {
        return new Property(
                "movable",
                "movable",
                "",
                Property.SWITCH,
                (scene, id) -> obstacle(scene, id).map(o -> Boolean.toString(o.movable())),
                (scene, id, text) -> {
                    Obstacle o = obstacle(scene, id).orElseThrow();
                    return scene.with(
                            with(o, o.offset(), o.height(), Boolean.parseBoolean(text), o.mass(), o.colour()));
                });
    }

    private static Property colour() {
        return Property.typed(
                "colour", "", (scene, id) -> obstacle(scene, id).map(Obstacle::colour), (scene, id, text) -> {
                    if (!text.strip().matches(COLOUR)) {
                        throw new IllegalArgumentException("'" + text + "': #rrggbb");
                    }
                    Obstacle o = obstacle(scene, id).orElseThrow();
                    return scene.with(with(o, o.offset(), o.height(), o.movable(), o.mass(), text.strip()));
                });
    }
}
