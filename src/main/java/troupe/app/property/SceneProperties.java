package troupe.app.property;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import troupe.scene.Scene;
import troupe.scene.World;

/** Lists the properties of the scene as a whole: its title and its world. */
final class SceneProperties {
    private SceneProperties() {}

    static List<Property> all() {
        return List.of(
                Property.typed(
                        "title",
                        "",
                        (scene, id) -> Optional.of(scene.title()),
                        (scene, id, text) -> new Scene(
                                text.strip(),
                                scene.world(),
                                scene.obstacles(),
                                scene.ditches(),
                                scene.actors(),
                                scene.tasks())),
                world("world.width", "world.size", World::width, (w, v) -> resized(w, v, w.depth())),
                world("world.depth", "world.size", World::depth, (w, v) -> resized(w, w.width(), v)),
                new Property(
                        "cell",
                        "cell",
                        "cm",
                        List.of(),
                        (scene, id) -> Optional.of(Typed.text(scene.world().cell() * 100, 2)),
                        (scene, id, text) -> scene.with(new World(
                                scene.world().width(),
                                scene.world().depth(),
                                Typed.number(text, Typed.POSITIVE) / 100))));
    }

    /** A cell that follows the size goes on doing so. */
    private static World resized(World before, double width, double depth) {
        boolean follows = World.of(before.width(), before.depth()).equals(before);
        return follows ? World.of(width, depth) : new World(width, depth, before.cell());
    }

    private static Property world(
            String key, String row, Function<World, Double> get, BiFunction<World, Double, World> set) {
        return new Property(
                key,
                row,
                "m",
                List.of(),
                (scene, id) -> Optional.of(Typed.text(get.apply(scene.world()), 2)),
                (scene, id, text) -> scene.with(set.apply(scene.world(), Typed.number(text, Typed.POSITIVE))));
    }
}
