package troupe.unified.search;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Makes seeded worlds of about fifteen cells a side in which every ability is worth something: bands that
 * reach from wall to wall (walls with a doorway, low walls, ditches, steps) and loose things.
 */
public final class SmallWorlds {
    private final Random random;
    private final double width;
    private final double depth;
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final List<Ditch> ditches = new ArrayList<>();

    private SmallWorlds(long seed) {
        random = new Random(seed);
        width = 3 + random.nextInt(5) * 0.25;
        depth = 2.5 + random.nextInt(5) * 0.25;
    }

    /** Makes a world of cells of 0.25 m. */
    public static Scene scene(long seed) {
        SmallWorlds made = new SmallWorlds(seed);
        int bands = 1 + made.random.nextInt(2);
        double at = 0.6;
        for (int i = 0; i < bands; i++) {
            double next = at + 0.2 + made.random.nextDouble() * (made.width / bands - 0.8);
            made.band(next, i);
            at = made.width * (i + 1) / bands + 0.2;
        }
        int loose = made.random.nextInt(4);
        for (int i = 0; i < loose; i++) {
            made.loose(i);
        }
        return new Scene(
                "", new World(made.width, made.depth, 0.25), made.obstacles, made.ditches, List.of(), List.of());
    }

    /** Makes an actor with the given abilities and random limits and energies, tight enough to bind. */
    public static Actor actor(long seed, boolean sidesteps, boolean strides, boolean vaults) {
        Random random = new Random(seed * 31 + 7);
        double gait = 0.7 + 0.7 * random.nextDouble();
        double reach = 0.9 + 0.7 * random.nextDouble();
        Actor.Stride stride = new Actor.Stride(
                gait, gait * (0.6 + random.nextDouble()), 0.5 + 2 * random.nextDouble(), 2 * random.nextDouble(), 1.5);
        Actor.Vault vault = new Actor.Vault(
                0.4,
                1.1,
                reach,
                1.2,
                reach * (0.5 + random.nextDouble()),
                1 + 3 * random.nextDouble(),
                5 * random.nextDouble(),
                1);
        double foot = 0.05 + 0.13 * random.nextDouble();
        return new Actor(
                "a",
                "",
                "",
                1.7,
                foot,
                0.25,
                0.25 + 0.6 * random.nextDouble(),
                new Actor.Walk(0.2 + 0.1 * random.nextDouble(), 0.5 + random.nextDouble(), 1.3),
                sidesteps
                        ? Optional.of(new Actor.Sidestep(0.19, 0.4 + 4 * random.nextDouble(), 0.6))
                        : Optional.empty(),
                strides ? Optional.of(stride) : Optional.empty(),
                vaults ? Optional.of(vault) : Optional.empty(),
                Optional.empty());
    }

    /** Makes preferences, neutral one time in three. */
    public static Preferences preferences(long seed) {
        Random random = new Random(seed * 17 + 3);
        Preferences preferences = Preferences.NEUTRAL;
        if (random.nextInt(3) > 0) {
            for (Ability ability : List.of(Ability.WALK, Ability.SIDESTEP, Ability.STRIDE, Ability.VAULT)) {
                preferences = preferences.with(ability, 0.2 + 3 * random.nextDouble());
            }
        }
        return preferences;
    }

    private void band(double x, int i) {
        double slant = random.nextInt(2) == 0 ? 0 : 0.8 * (random.nextDouble() - 0.5);
        String id = "band" + i;
        switch (random.nextInt(6)) {
            case 0 -> {
                double door = 0.3 + random.nextDouble() * (depth - 0.9);
                double gap = 0.36 + 0.4 * random.nextDouble();
                add(id, strip(x, 0.15, -0.1, door, 0), 0, 2.5, false);
                add(id + "b", strip(x, 0.15, door + gap, depth + 0.1, 0), 0, 2.5, false);
            }
            case 1 -> add(id, strip(x, 0.05 + 0.4 * random.nextDouble(), -0.1, depth + 0.1, slant), 0, lowTop(), false);
            case 2, 3 -> ditch(id, strip(x, 0.05 + 0.45 * random.nextDouble(), -0.1, depth + 0.1, slant));
            case 4 -> {
                add(id, strip(x, 0.35 + 0.3 * random.nextDouble(), -0.1, depth + 0.1, slant), 0, 0.2, false);
                add(id + "b", strip(x + 0.5, 0.3, -0.1, depth + 0.1, slant), 0, 0.4, false);
            }
            default -> {
                double top = lowTop();
                double door = random.nextDouble() * (depth - 0.5);
                add(id, strip(x, 0.2, -0.1, door, slant), 0, top, false);
                add(id + "b", strip(x, 0.2, door, depth + 0.1, slant), 0, 2.5, false);
            }
        }
    }

    private double lowTop() {
        return 0.4 + random.nextInt(8) * 0.1;
    }

    private void loose(int i) {
        double x = random.nextDouble() * width;
        double y = random.nextDouble() * depth;
        Polygon outline = Polygon.rectangle(x - 0.3, y - 0.3, x + 0.1 + random.nextDouble(), y + random.nextDouble());
        String id = "loose" + i;
        switch (random.nextInt(6)) {
            case 0 -> add(id, outline, 0, 2, false);
            case 1 -> add(id, outline, 0, 0.2, false);
            case 2 -> add(id, outline, 0, lowTop(), random.nextBoolean());
            case 3 -> add(id, outline, 1.2 + random.nextDouble(), 0.2, false);
            case 4 -> ditch(id, outline);
            default -> add(id, outline, 0.6, 0.1, false);
        }
    }

    private void add(String id, Polygon outline, double offset, double height, boolean movable) {
        obstacles.add(new Obstacle(id, "", outline, offset, height, movable, Obstacle.DEFAULT_MASS, ""));
    }

    private void ditch(String id, Polygon outline) {
        ditches.add(new Ditch(id, "", outline, random.nextInt(4) == 0 ? 0.2 : 1 + random.nextDouble()));
    }

    private Polygon strip(double x, double across, double from, double to, double slant) {
        if (to <= from + 0.01) {
            return Polygon.rectangle(x, from - 0.02, x + across, from);
        }
        return Polygon.of(x, from, x + across, from, x + across + slant, to, x + slant, to);
    }
}
