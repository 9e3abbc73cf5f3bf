package troupe.grid.region;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;

/** Makes seeded random scenes and actors for the grid's tests; the same seed gives the same scene on any machine. */
public final class RandomScenes {
    private final Random random;
    private final double width;
    private final double depth;
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final List<Ditch> ditches = new ArrayList<>();

    private RandomScenes(long seed, double width, double depth) {
        this.random = new Random(seed);
        this.width = width;
        this.depth = depth;
    }

    /** Makes a scene of one floor: {@code count} obstacles of full height, turned rectangles and stars. */
    public static Scene flat(long seed, double side, double cell, int count) {
        RandomScenes made = new RandomScenes(seed, side, side);
        for (int i = 0; i < count; i++) {
            made.solid(made.shape(side / 4), 0, 3, false);
        }
        return made.scene(cell);
    }

    /** Makes a layered scene: walls, thin walls, low walls, tables, decks, stairs, bridges, ditches, crates. */
    public static Scene layered(long seed, double side, double cell) {
        RandomScenes made = new RandomScenes(seed, side, side);
        int count = 3 + made.random.nextInt(7);
        for (int i = 0; i < count; i++) {
            made.something();
        }
        return made.scene(cell);
    }

    /** Makes an actor with random abilities and sizes that the checks of a scene would accept. */
    public static Actor actor(long seed) {
        Random random = new Random(seed);
        double walk = random.nextInt(4) == 0 ? 0.3 * random.nextDouble() : 0.15 + 0.2 * random.nextDouble();
        double sidestep = walk * (0.3 + 0.6 * random.nextDouble());
        double foot = random.nextInt(4) == 0 ? 0 : sidestep * (0.2 + 0.7 * random.nextDouble());
        Actor standard = Actor.standard("a" + seed);
        return new Actor(
                standard.id(),
                "",
                "",
                1.4 + 0.5 * random.nextDouble(),
                foot,
                0.15 + 0.15 * random.nextDouble(),
                0.6,
                new Actor.Walk(walk, 1, 1.3),
                random.nextInt(4) == 0 ? Optional.empty() : Optional.of(new Actor.Sidestep(sidestep, 2, 0.6)),
                random.nextInt(3) == 0 ? Optional.empty() : standard.stride(),
                random.nextInt(3) == 0 ? Optional.empty() : standard.vault(),
                Optional.empty());
    }

    private Scene scene(double cell) {
        return new Scene("", new World(width, depth, cell), obstacles, ditches, List.of(), List.of());
    }

    private void something() {
        double side = Math.max(width, depth);
        switch (random.nextInt(10)) {
            case 0 -> solid(shape(side / 4), 0, 2 + random.nextDouble(), false);
            case 1 -> solid(bar(side * random.nextDouble(), 0.02 + 0.1 * random.nextDouble()), 0, 2.5, false);
            case 2 -> solid(bar(side * random.nextDouble(), 0.3), 0, 0.4 + 0.6 * random.nextDouble(), false);
            case 3 -> solid(bar(1.5, 0.7), 0.7, 0.05, false);
            case 4 -> solid(shape(side / 3), 1.2 + random.nextDouble(), 0.1 + random.nextDouble(), false);
            case 5 -> stairs(false);
            case 6 -> stairs(true);
            case 7 -> ditches.add(new Ditch("d" + ditches.size(), "", shape(side / 4), depth(0.6)));
            case 8 -> ditches.add(new Ditch("d" + ditches.size(), "", bar(side * random.nextDouble(), 0.5), depth(2)));
            default -> solid(bar(0.6, 0.6), 0, 0.1 + 0.8 * random.nextDouble(), true);
        }
    }

    private double depth(double most) {
        return random.nextBoolean() ? 0.5 : 0.05 + most * random.nextDouble();
    }

    private void solid(Polygon outline, double offset, double height, boolean movable) {
        obstacles.add(new Obstacle("o" + obstacles.size(), "", outline, offset, height, movable, 20, ""));
    }

    /** Adds axis-parallel steps, and for a bridge a deck that goes on from the last of them. */
    private void stairs(boolean bridge) {
        double x = width * random.nextDouble();
        double y = depth * random.nextDouble();
        double tread = 0.3 + 0.2 * random.nextDouble();
        double broad = 0.6 + random.nextDouble();
        double rise = 0.1 + 0.1 * random.nextDouble();
        int steps = bridge ? 12 : 2 + random.nextInt(5);
        for (int i = 0; i < steps; i++) {
            solid(Polygon.rectangle(x + i * tread, y, x + (i + 1) * tread, y + broad), 0, (i + 1) * rise, false);
        }
        if (bridge) {
            double top = steps * rise;
            double from = x + steps * tread;
            solid(Polygon.rectangle(from, y, from + width / 2, y + broad), top - 0.1, 0.1, false);
        }
    }

    private Polygon shape(double size) {
        return random.nextBoolean()
                ? bar(size * random.nextDouble() + 0.2, size * random.nextDouble() + 0.2)
                : star(size);
    }

    /** Makes a rectangle of the given sides at a random place, half the time turned. */
    private Polygon bar(double length, double thickness) {
        double x = width * random.nextDouble();
        double y = depth * random.nextDouble();
        double angle = random.nextBoolean() ? 0 : Math.PI * random.nextDouble();
        double cos = StrictMath.cos(angle) / 2;
        double sin = StrictMath.sin(angle) / 2;
        return Polygon.of(
                x - length * cos + thickness * sin,
                y - length * sin - thickness * cos,
                x + length * cos + thickness * sin,
                y + length * sin - thickness * cos,
                x + length * cos - thickness * sin,
                y + length * sin + thickness * cos,
                x - length * cos - thickness * sin,
                y - length * sin + thickness * cos);
    }

    private Polygon star(double size) {
        int corners = 3 + random.nextInt(6);
        double x = width * random.nextDouble();
        double y = depth * random.nextDouble();
        double[] coordinates = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double radius = size * (0.2 + 0.4 * random.nextDouble());
            coordinates[2 * i] = x + radius * StrictMath.cos(2 * Math.PI * i / corners);
            coordinates[2 * i + 1] = y + radius * StrictMath.sin(2 * Math.PI * i / corners);
        }
        return Polygon.of(coordinates);
    }
}
