package troupe.unified.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Makes seeded worlds of a dozen cells a side whose walls have doorways with crates in them, at coordinates so
 * random that no two distances are the same, and now and then a low wall, a ditch, a platform or a loaded crate.
 */
public final class MovingWorlds {
    private static final double WALL = 2.4;

    private final Random random;
    private final double cell;
    private final double width;
    private final double depth;
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final List<Ditch> ditches = new ArrayList<>();

    private MovingWorlds(long seed) {
        random = new Random(seed * 7_919 + 13);
        cell = new double[] {0.25, 0.25, 0.2, 0.2, 0.16}[random.nextInt(5)];
        width = 2.8 + 1.6 * random.nextDouble();
        depth = 1.8 + 1.2 * random.nextDouble();
    }

    /** Makes a scene with one actor, who may be able to vault, and one journey through it. */
    public static Scene scene(long seed, Journey.Manipulation manipulation) {
        return scene(seed, manipulation, true);
    }

    /** Makes a scene with one actor and one journey through it. */
    public static Scene scene(long seed, Journey.Manipulation manipulation, boolean vaults) {
        MovingWorlds made = new MovingWorlds(seed);
        made.build();
        Actor actor = made.actor();
        Scene bare = new Scene(
                "",
                new World(made.width, made.depth, made.cell),
                made.obstacles,
                made.ditches,
                List.of(actor),
                List.of());
        Ground ground = new Ground(bare, actor);
        Polygon[] none = new Polygon[made.obstacles.size()];
        Polygon[] all = made.obstacles.stream()
                .map(o -> o.movable() ? o.outline() : null)
                .toArray(Polygon[]::new);
        Place start = made.place(new Space(ground, all), 0, made.width / 3);
        Place goal =
                made.place(new Space(ground, made.random.nextInt(8) == 0 ? none : all), made.width * 2 / 3, made.width);
        boolean back = made.random.nextInt(3) == 0 && made.isOpen(new Space(ground, all), goal);
        Journey journey = Journey.of("j", actor.id(), back ? goal : start, back ? start : goal)
                .preferring(made.preferences())
                .withHeadings(made.random.nextInt(3) == 0 ? 8 : 4)
                .with(manipulation);
        return new Scene("seed " + seed, bare.world(), made.obstacles, made.ditches, List.of(actor), List.of(journey));
    }

    private boolean isOpen(Space space, Place place) {
        return space.open(space.ground.cellAt(place.x(), place.y()));
    }

    private Place place(Space space, double from, double to) {
        List<Place> places = new ArrayList<>();
        for (int q = 0; q < space.ground.spanCount; q++) {
            double x = space.ground.x(q % space.ground.cells);
            if (space.open(q) && x >= from && x <= to) {
                places.add(Place.of(x, space.ground.y(q % space.ground.cells), space.ground.floor[q]));
            }
        }
        return places.isEmpty() ? Place.of((from + to) / 2, depth / 2) : places.get(random.nextInt(places.size()));
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private Actor actor() {
        double gait = between(0.7, 1.3);
        double reach = between(0.9, 1.5);
        Actor.Stride stride = new Actor.Stride(gait, gait * between(0.7, 1.5), between(0.5, 2), between(0, 2), 1.5);
        Actor.Vault vault =
                new Actor.Vault(0.4, 1.1, reach, 1.2, reach * between(0.7, 1.5), between(1, 4), between(0, 4), 1);
        Actor.Sidestep sidestep = new Actor.Sidestep(between(0.13, 0.18), between(0.6, 4), 0.6);
        return new Actor(
                "a",
                "",
                "",
                1.7,
                between(0.04, 0.12),
                0.25,
                between(0.3, 0.8),
                new Actor.Walk(between(0.185, 0.27), between(0.5, 1.5), 1.3),
                random.nextBoolean() ? Optional.of(sidestep) : Optional.empty(),
                random.nextInt(5) < 2 ? Optional.of(stride) : Optional.empty(),
                random.nextInt(5) < 2 ? Optional.of(vault) : Optional.empty(),
                Optional.of(
                        new Actor.Move(between(0.05, 0.6), random.nextBoolean() ? 0.002 : between(0.01, 0.1), 0.5)));
    }

    private Preferences preferences() {
        Preferences preferences = Preferences.NEUTRAL;
        if (random.nextBoolean()) {
            for (Ability ability : Ability.values()) {
                preferences = preferences.with(ability, between(0.3, 2.5));
            }
        }
        return preferences;
    }

    private void build() {
        int walls = random.nextInt(4) == 0 ? 2 : 1;
        for (int i = 0; i < walls; i++) {
            band((i + 0.5) * width / walls + between(-0.2, 0.2), walls);
        }
        for (int loose = random.nextInt(6) - 3; loose > 0; loose--) {
            crate(between(0.3, width - 0.3), between(0.3, depth - 0.3), 0.25, 0);
        }
        switch (random.nextInt(9)) {
            case 0 ->
                ditches.add(new Ditch("ditch", "", turned(between(0, width), between(0, depth), 0.4, 0.6), depth()));
            case 1 ->
                fixed("low", turned(between(0, width), between(0, depth), between(0.5, 1.5), 0.15), between(0.4, 1));
            case 2 -> fixed("post", turned(between(0, width), between(0, depth), 0.25, 0.2), WALL);
            default -> load();
        }
    }

    private double depth() {
        return random.nextInt(3) == 0 ? 0.2 : 1.5;
    }

    /** Puts something onto the last crate, one time in eight. */
    private void load() {
        if (random.nextInt(8) == 0 && !obstacles.isEmpty()) {
            Obstacle last = obstacles.get(obstacles.size() - 1);
            if (last.movable()) {
                double[] c = Shapes.centroid(last.outline());
                obstacles.add(new Obstacle(
                        "load", "", turned(c[0], c[1], 0.15, 0.1), last.top(), 0.3, random.nextBoolean(), 3, ""));
            }
        }
    }

    /** Adds a wall from side to side, or something like it, with a doorway or two and something in these. */
    private void band(double x, int walls) {
        double thick = between(0.08, 0.3);
        double door = between(0.3, depth - 1);
        double wide = between(0.55, 1.05);
        double slant = random.nextBoolean() ? 0 : between(-0.2, 0.2);
        String id = "band" + obstacles.size();
        fixed(id, strip(x, thick, -0.1, door, slant), WALL);
        double low = random.nextInt(8) == 0 ? between(0.4, 1.1) : WALL;
        if (random.nextInt(4) == 0 && depth - door - wide > 1) {
            double second = between(door + wide + 0.1, depth - 0.7);
            fixed(id + "m", strip(x, thick, door + wide, second, slant), low);
            fixed(id + "t", strip(x, thick, second + between(0.45, 0.7), depth + 0.1, slant), WALL);
            fill(x + thick / 2, second + 0.3, thick);
        } else {
            fixed(id + "t", strip(x, thick, door + wide, depth + 0.1, slant), low);
        }
        fill(x + thick / 2 + slant / 2, door + wide / 2, wide);
        if (walls == 1 && random.nextInt(3) == 0) {
            crate(x + between(-0.7, 0.9), door + wide / 2 + between(-0.3, 0.3), 0.3, 0);
        }
    }

    private void fill(double x, double y, double wide) {
        switch (random.nextInt(10)) {
            case 0 -> {
                double top = between(0.1, 0.25);
                fixed("plate" + obstacles.size(), turned(x, y, between(0.5, 1), between(0.5, 1.1)), top);
                crate(x, y, wide, top);
            }
            case 1 ->
                ditches.add(new Ditch("gap" + obstacles.size(), "", turned(x, y, between(0.1, 0.4), 1.2), depth()));
            default -> crate(x, y, wide, 0);
        }
    }

    /** Adds a movable box or triangle near a place where it overlaps nothing, if one is found. */
    private void crate(double x, double y, double wide, double offset) {
        for (int tries = 0; tries < 25; tries++) {
            double size = between(0.25, Math.max(0.35, wide));
            Polygon outline = random.nextInt(5) == 0
                    ? triangle(x + between(-0.2, 0.2), y + between(-0.2, 0.2), size)
                    : turned(x + between(-0.25, 0.25), y + between(-0.15, 0.15), between(0.2, 0.55), size);
            double height = random.nextInt(5) < 2 ? between(0.15, 1.2) : 1.5;
            Obstacle crate =
                    new Obstacle("crate" + obstacles.size(), "", outline, offset, height, true, between(4, 40), "");
            if (isFree(crate)) {
                obstacles.add(crate);
                return;
            }
        }
    }

    private boolean isFree(Obstacle crate) {
        boolean free = crate.outline().bounds().minX() > 0
                && crate.outline().bounds().minY() > 0
                && crate.outline().bounds().maxX() < width
                && crate.outline().bounds().maxY() < depth;
        for (Obstacle o : obstacles) {
            free = free
                    && !(Ground.meets(o.offset(), o.top(), crate.offset(), crate.top())
                            && Shapes.overlap(o.outline(), crate.outline(), 1e-6));
        }
        return free;
    }

    private void fixed(String id, Polygon outline, double height) {
        obstacles.add(new Obstacle(id, "", outline, 0, height, false, 20, ""));
    }

    private static Polygon strip(double x, double thick, double from, double to, double slant) {
        return Polygon.of(x, from, x + thick, from, x + thick + slant, to, x + slant, to);
    }

    private Polygon triangle(double x, double y, double size) {
        double from = between(0, 2 * Math.PI);
        double[] corners = new double[6];
        for (int i = 0; i < 3; i++) {
            double angle = from + 2 * Math.PI / 3 * i + between(0, 1);
            corners[2 * i] = x + size * 0.6 * StrictMath.cos(angle);
            corners[2 * i + 1] = y + size * 0.6 * StrictMath.sin(angle);
        }
        return Polygon.of(corners);
    }

    /** Makes a rectangle about a place, turned one time in two. */
    private Polygon turned(double x, double y, double length, double across) {
        double angle = random.nextBoolean() ? between(-0.02, 0.02) : between(0, Math.PI);
        double cos = StrictMath.cos(angle) / 2;
        double sin = StrictMath.sin(angle) / 2;
        return Polygon.of(
                x - length * cos + across * sin,
                y - length * sin - across * cos,
                x + length * cos + across * sin,
                y + length * sin - across * cos,
                x + length * cos - across * sin,
                y + length * sin + across * cos,
                x - length * cos - across * sin,
                y - length * sin + across * cos);
    }
}
