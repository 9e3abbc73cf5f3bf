package troupe.grid.region;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Makes seeded random scenes with movable obstacles, and places for them; not all of these could be reached. */
final class MovableScenes {
    private MovableScenes() {}

    /** Returns a layered scene with one to five movable obstacles more: on the ground, on tops, in the air. */
    static Scene scene(long seed, double side, double cell) {
        Scene layered = RandomScenes.layered(seed, side, cell);
        Random random = new Random(~seed);
        List<Obstacle> obstacles = new ArrayList<>(layered.obstacles());
        int count = 1 + random.nextInt(5);
        for (int i = 0; i < count; i++) {
            Obstacle under = layered.obstacles().isEmpty()
                    ? null
                    : layered.obstacles().get(random.nextInt(layered.obstacles().size()));
            double offset = random.nextInt(3) > 0 || under == null ? 0 : under.top();
            double height = random.nextInt(4) == 0 ? 0.05 + 0.2 * random.nextDouble() : 0.4 + random.nextDouble();
            Obstacle movable = new Obstacle("m" + i, "", box(random, side), offset, height, true, 20, "");
            obstacles.add(random.nextInt(obstacles.size() + 1), movable);
        }
        return new Scene("", layered.world(), obstacles, layered.ditches(), List.of(), List.of());
    }

    /** Returns the outline somewhere else: shifted a little, turned, anywhere, or partly outside. */
    static Polygon moved(Polygon outline, double side, Random random) {
        double far = random.nextInt(3) == 0 ? side : 0.5;
        double turn = random.nextBoolean() ? 0 : 6 * random.nextDouble();
        double x = outline.centroid().x() + far * (random.nextDouble() - 0.5);
        double y = outline.centroid().y() + far * (random.nextDouble() - 0.5);
        return outline.at(new Pose(x, y, turn));
    }

    /** Returns the scene in which the movable obstacles stand elsewhere, or are not there. */
    static Scene with(Scene scene, List<Optional<Polygon>> outlines) {
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 0; i < outlines.size(); i++) {
            Obstacle obstacle = scene.obstacles().get(i);
            outlines.get(i).ifPresent(outline -> obstacles.add(obstacle.withOutline(outline)));
        }
        return new Scene("", scene.world(), obstacles, scene.ditches(), List.of(), List.of());
    }

    /** Returns an actor that can move obstacles, with other abilities as chance will have it. */
    static Actor actor(long seed) {
        Actor some = RandomScenes.actor(seed);
        return new Actor(
                some.id(),
                "",
                "",
                some.bodyHeight(),
                some.footRadius(),
                some.stepHeight(),
                some.maxBorder(),
                some.walk(),
                some.sidestep(),
                some.stride(),
                some.vault(),
                Actor.standard("").move());
    }

    private static Polygon box(Random random, double side) {
        double x = side * random.nextDouble();
        double y = side * random.nextDouble();
        Polygon straight = Polygon.rectangle(x, y, x + 0.2 + random.nextDouble(), y + 0.2 + 0.6 * random.nextDouble());
        return random.nextBoolean() ? straight : straight.at(new Pose(x, y, 6 * random.nextDouble()));
    }
}
