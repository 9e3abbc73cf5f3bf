package troupe.unified;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import troupe.geometry.Overlap;
import troupe.geometry.Polygon;
import troupe.grid.region.RandomScenes;
import troupe.grid.region.Region;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Makes seeded layered scenes with a wall across them whose doorway is barred by things of many shapes, on the
 * ground or on whatever is there, and cells of 0.1 m.
 */
final class LayeredStores {
    private static final double SIDE = 5;

    private final Random random;
    private final List<Obstacle> obstacles;

    private LayeredStores(long seed, Scene bare) {
        random = new Random(seed * 131 + 5);
        obstacles = new ArrayList<>(bare.obstacles());
        obstacles.removeIf(o -> o.movable() && meetsAny(o, List.of(o)));
    }

    /** Makes a scene with an actor of any size that can move things, and one journey through the doorway. */
    static Scene scene(long seed) {
        Scene bare = RandomScenes.layered(seed, SIDE, 0.1);
        LayeredStores made = new LayeredStores(seed, bare);
        double door = made.between(1, SIDE - 2);
        double wide = made.between(0.6, 1.2);
        double x = made.between(2.2, 2.8);
        made.obstacles.add(wall("below", x, 0, door));
        made.obstacles.add(wall("above", x, door + wide, SIDE));
        for (int i = 0; i < 6; i++) {
            made.thing("thing" + i, x + made.between(-0.4, 0.5), door + made.between(0, wide));
        }
        Actor someone = RandomScenes.actor(seed);
        Actor actor = new Actor(
                someone.id(),
                "",
                "",
                someone.bodyHeight(),
                someone.footRadius(),
                someone.stepHeight(),
                someone.maxBorder(),
                someone.walk(),
                someone.sidestep(),
                someone.stride(),
                someone.vault(),
                Optional.of(new Actor.Move(0.05, 0.02, 0.5)));
        Scene empty =
                new Scene("seed " + seed, bare.world(), made.obstacles, bare.ditches(), List.of(actor), List.of());
        Region region = Region.of(empty, actor);
        Journey journey = Journey.of("j", actor.id(), made.place(region, 0.3, 1.8), made.place(region, 3.2, SIDE - 0.3))
                .with(seed % 3 == 0 ? Journey.Manipulation.FREE : Journey.Manipulation.GRIP)
                .limited(2_000, 20_000);
        return new Scene(
                "seed " + seed, bare.world(), made.obstacles, bare.ditches(), List.of(actor), List.of(journey));
    }

    /** Chooses a place where the actor can stand, if chance finds one. */
    private Place place(Region region, double from, double to) {
        int q = 0;
        for (int tries = 0; tries < 1_000; tries++) {
            q = random.nextInt(region.spanCount());
            if (region.open(q) && region.x(q) >= from && region.x(q) <= to) {
                break;
            }
        }
        return Place.of(region.x(q), region.y(q), region.elevation(q));
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private static Obstacle wall(String id, double x, double from, double to) {
        return new Obstacle(id, "", Polygon.rectangle(x, from, x + 0.15, to), 0, 4, false, 20, "");
    }

    /** Puts something movable at a place, on the highest top there under half a metre, if it fits. */
    private void thing(String id, double x, double y) {
        double offset = 0;
        for (Obstacle o : obstacles) {
            if (!o.movable() && o.top() < 0.5 && o.outline().contains(x, y)) {
                offset = Math.max(offset, o.top());
            }
        }
        double height = random.nextInt(3) == 0 ? between(0.1, 0.9) : between(1, 2);
        Obstacle thing = new Obstacle(id, "", outline(x, y), offset, height, true, between(5, 30), "");
        if (!meetsAny(thing, List.of())) {
            obstacles.add(thing);
        }
    }

    /** Makes a box, or an L of two boxes, turned as it comes. */
    private Polygon outline(double x, double y) {
        double a = between(0.15, 0.45);
        double b = between(0.1, 0.3);
        double[] corners = random.nextInt(3) == 0
                ? new double[] {-a, -b, a, -b, a, 0, 0, 0, 0, b, -a, b}
                : new double[] {-a, -b, a, -b, a, b, -a, b};
        double angle = random.nextBoolean() ? 0 : between(0, Math.PI);
        double[] xs = new double[corners.length / 2];
        double[] ys = new double[xs.length];
        for (int i = 0; i < xs.length; i++) {
            double u = corners[2 * i];
            double v = corners[2 * i + 1];
            xs[i] = x + u * StrictMath.cos(angle) - v * StrictMath.sin(angle);
            ys[i] = y + u * StrictMath.sin(angle) + v * StrictMath.cos(angle);
        }
        return new Polygon(xs, ys);
    }

    private boolean meetsAny(Obstacle thing, List<Obstacle> but) {
        for (Obstacle o : obstacles) {
            boolean level = o.offset() < thing.top() && thing.offset() < o.top();
            if (!but.contains(o) && level && Overlap.of(o.outline(), thing.outline())) {
                return true;
            }
        }
        return false;
    }
}
