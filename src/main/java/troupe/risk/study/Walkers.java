package troupe.risk.study;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.xml.TrackTable;

/**
 * Puts an actor into the place of recorded walkers, one after another: it starts where and when the walker did,
 * heads for where he went, at his mean speed, among all the others as recorded. They do not see the actor.
 */
public final class Walkers {
    /** The id of the one task of the scenes. */
    public static final String TASK = "walk";

    /** The radius of everybody in metres: two collide below 0.4 m. */
    public static final double RADIUS = 0.2;

    private static final double MARGIN = 1.5;
    private static final double CELL = 0.1;
    /** A walker goes at least so far and so fast. */
    private static final double LEAST_METRES = 4;

    private static final double LEAST_SPEED = 0.5;
    /** Others matter so many seconds beyond the walker's own time. */
    private static final double BEYOND = 30;

    private final List<TrackTable.Person> people;
    private final List<Polygon> walls;
    private double left = Double.POSITIVE_INFINITY;
    private double bottom = Double.POSITIVE_INFINITY;
    private double right = Double.NEGATIVE_INFINITY;
    private double top = Double.NEGATIVE_INFINITY;

    /** One walker: his number, the seconds that he took, and the encounter in which the actor takes his place. */
    public record Walker(long id, double seconds, Scene scene) {}

    /** Looks at tracks and walls in the same frame of metres. */
    public Walkers(TrackTable tracks, List<Polygon> walls) {
        this.people = tracks.people();
        this.walls = List.copyOf(walls);
        people.forEach(p -> p.fixes().forEach(fix -> include(fix.x(), fix.y())));
    }

    private void include(double x, double y) {
        left = Math.min(left, x - MARGIN);
        right = Math.max(right, x + MARGIN);
        bottom = Math.min(bottom, y - MARGIN);
        top = Math.max(top, y + MARGIN);
    }

    /** Returns at most {@code most} walkers, spread evenly over those who go far enough. */
    public List<Walker> choose(int most) {
        List<TrackTable.Person> fit = people.stream().filter(this::walks).toList();
        List<Walker> chosen = new ArrayList<>();
        int count = Math.min(most, fit.size());
        for (int k = 0; k < count; k++) {
            chosen.add(walker(fit.get((int) ((long) k * fit.size() / count))));
        }
        return chosen;
    }

    private boolean walks(TrackTable.Person person) {
        Avatar.Fix first = person.fixes().get(0);
        Avatar.Fix last = person.fixes().get(person.fixes().size() - 1);
        double seconds = last.time() - first.time();
        double far = Math.hypot(last.x() - first.x(), last.y() - first.y());
        return far >= LEAST_METRES && far >= LEAST_SPEED * seconds && stands(first) && stands(last);
    }

    private boolean stands(Avatar.Fix fix) {
        return walls.stream().noneMatch(wall -> wall.distance(fix.x(), fix.y()) < RADIUS + 2 * CELL);
    }

    private Walker walker(TrackTable.Person person) {
        Avatar.Fix first = person.fixes().get(0);
        Avatar.Fix last = person.fixes().get(person.fixes().size() - 1);
        double seconds = last.time() - first.time();
        List<Avatar> others = new ArrayList<>();
        for (TrackTable.Person other : people) {
            List<Avatar.Fix> fixes = other.fixes();
            boolean meets = fixes.get(0).time() <= last.time() + BEYOND
                    && fixes.get(fixes.size() - 1).time() >= first.time();
            if (other.id() != person.id() && meets) {
                List<Avatar.Fix> moved = fixes.stream()
                        .map(f -> new Avatar.Fix(f.time() - first.time(), f.x() - left, f.y() - bottom))
                        .toList();
                others.add(new Avatar(
                        "p" + other.id(),
                        "",
                        "",
                        RADIUS,
                        Avatar.DEFAULT_SPEED,
                        Avatar.DEFAULT_MOBILITY,
                        Avatar.Kind.UNCERTAIN,
                        new Avatar.Recording(moved)));
            }
        }
        Encounter encounter = Encounter.of(
                TASK,
                "actor",
                Place.of(first.x() - left, first.y() - bottom),
                Place.of(last.x() - left, last.y() - bottom),
                others);
        return new Walker(person.id(), seconds, scene(person, encounter, seconds));
    }

    private Scene scene(TrackTable.Person person, Encounter encounter, double seconds) {
        double way = 0;
        for (int k = 1; k < person.fixes().size(); k++) {
            Avatar.Fix a = person.fixes().get(k - 1);
            Avatar.Fix b = person.fixes().get(k);
            way += Math.hypot(b.x() - a.x(), b.y() - a.y());
        }
        Actor plain = Actor.walker("actor", RADIUS, 0.1);
        Actor actor = new Actor(
                plain.id(),
                "",
                "",
                plain.bodyHeight(),
                plain.footRadius(),
                plain.stepHeight(),
                plain.maxBorder(),
                new Actor.Walk(RADIUS, 1, way / seconds),
                plain.sidestep(),
                plain.stride(),
                plain.vault(),
                plain.move());
        List<Obstacle> obstacles = new ArrayList<>();
        for (Polygon wall : walls) {
            double[] xs = new double[wall.size()];
            double[] ys = new double[wall.size()];
            for (int k = 0; k < xs.length; k++) {
                xs[k] = wall.x(k) - left;
                ys[k] = wall.y(k) - bottom;
            }
            obstacles.add(new Obstacle(
                    "wall" + obstacles.size(), "", new Polygon(xs, ys), 0, 2.5, false, Obstacle.DEFAULT_MASS, ""));
        }
        return new Scene(
                "In the place of walker " + person.id(),
                new World(right - left, top - bottom, CELL),
                obstacles,
                List.of(),
                List.of(actor),
                List.of(encounter));
    }
}
