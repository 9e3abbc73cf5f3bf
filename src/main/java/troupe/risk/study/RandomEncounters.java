package troupe.risk.study;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Makes encounters by chance: a square with up to four blocks, an actor that crosses it, and avatars that head for
 * one place after another and change their minds every one to four seconds. They look neither at the actor nor at
 * each other, but keep clear of the blocks.
 */
public final class RandomEncounters {
    /** The id of the one task of the scenes. */
    public static final String TASK = "meet";

    /** The most avatars of an encounter. */
    public static final int MOST = 10;

    private static final double WIDTH = 12;
    private static final double DEPTH = 10;
    private static final double CELL = 0.1;
    private static final double SECONDS = 45;
    private static final double RADIUS = 0.25;
    /** Nobody starts so near to the actor. */
    private static final double APART = 2;
    /** The actor's ends keep so far from blocks. */
    private static final double ROOM = 0.8;

    private static final int TRIES = 60;

    private final Random chance;
    private final List<Obstacle> blocks = new ArrayList<>();

    private RandomEncounters(long seed) {
        // neighbouring seeds of the generator start alike
        this.chance = new Random(seed * 0x9E3779B97F4A7C15L + 0x7F4A7C15L);
    }

    /** Makes the encounter of a seed, with 1 to {@link #MOST} avatars by chance. */
    public static Scene scene(long seed) {
        RandomEncounters made = new RandomEncounters(seed);
        return made.scene(seed, 1 + made.chance.nextInt(MOST));
    }

    private Scene scene(long seed, int count) {
        Place start = Place.of(0.8, within(1, DEPTH - 1));
        Place goal = Place.of(WIDTH - 0.8, within(1, DEPTH - 1));
        int many = chance.nextInt(5);
        for (int k = 0; k < many; k++) {
            double x = within(2, WIDTH - 3.5);
            double y = within(0.5, DEPTH - 2);
            Polygon box = Polygon.rectangle(x, y, x + within(0.5, 1.5), y + within(0.5, 1.5));
            if (box.distance(start.x(), start.y()) > ROOM && box.distance(goal.x(), goal.y()) > ROOM) {
                blocks.add(new Obstacle("block" + k, "", box, 0, 2, false, Obstacle.DEFAULT_MASS, ""));
            }
        }
        List<Avatar> avatars = new ArrayList<>();
        for (int a = 0; a < count; a++) {
            avatars.add(Avatar.of("a" + (a + 1), script(start)));
        }
        return new Scene(
                "Encounter " + seed,
                new World(WIDTH, DEPTH, CELL),
                blocks,
                List.of(),
                List.of(Actor.walker("ann", RADIUS, 0.1)),
                List.of(Encounter.of(TASK, "ann", start, goal, avatars).seeded(seed)));
    }

    private double within(double low, double high) {
        return low + (high - low) * chance.nextDouble();
    }

    private Avatar.Script script(Place actor) {
        double x = 0;
        double y = 0;
        for (int tries = 0; tries < TRIES; tries++) {
            x = within(0.5, WIDTH - 0.5);
            y = within(0.5, DEPTH - 0.5);
            if (Math.hypot(x - actor.x(), y - actor.y()) > APART && free(x, y, x, y)) {
                break;
            }
        }
        Place start = Place.of(x, y);
        double pace = within(0.6, 1.4);
        List<Avatar.Head> heads = new ArrayList<>();
        for (double time = 0; time < SECONDS; ) {
            Place to = next(x, y);
            heads.add(new Avatar.Head(to, OptionalDouble.of(time)));
            double lasts = within(1, 4);
            double way = Math.hypot(to.x() - x, to.y() - y);
            double share = way > 0 ? Math.min(1, pace * lasts / way) : 0;
            x += share * (to.x() - x);
            y += share * (to.y() - y);
            time += lasts;
        }
        return new Avatar.Script(start, pace, heads);
    }

    /** Chooses a place that the straight line leads to; where there is none, the avatar stays. */
    private Place next(double x, double y) {
        for (int tries = 0; tries < TRIES; tries++) {
            double toX = within(0.5, WIDTH - 0.5);
            double toY = within(0.5, DEPTH - 0.5);
            if (free(x, y, toX, toY)) {
                return Place.of(toX, toY);
            }
        }
        return Place.of(x, y);
    }

    private boolean free(double x0, double y0, double x1, double y1) {
        int pieces = 1 + (int) (Math.hypot(x1 - x0, y1 - y0) / 0.1);
        for (Obstacle block : blocks) {
            for (int k = 0; k <= pieces; k++) {
                double share = (double) k / pieces;
                if (block.outline().distance(x0 + share * (x1 - x0), y0 + share * (y1 - y0)) < RADIUS) {
                    return false;
                }
            }
        }
        return true;
    }
}
