package troupe.unified.body;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import troupe.geometry.Box;
import troupe.geometry.Line;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Decides on the polygons themselves, not on the grid, whether an actor's body and feet fit along a
 * straight line. Metres throughout; distances are compared with a slack of 1e-9 m. Immutable, safe for
 * any thread; a question costs O(obstacles) plus the corners of those near the line.
 */
public final class SweptBody {
    /** How far in metres a distance may fall short of a radius. */
    public static final double SLACK = 1e-9;

    private final World world;
    private final Actor actor;
    private final Obstacle[] obstacles;
    private final FloorEdges floors;

    /** Prepares the questions of one actor in one scene. */
    public SweptBody(Scene scene, Actor actor) {
        this.world = scene.world();
        this.actor = actor;
        this.obstacles = scene.obstacles().toArray(new Obstacle[0]);
        this.floors = new FloorEdges(
                scene.obstacles().stream().filter(o -> !o.movable()).toList(), scene.ditches());
    }

    /**
     * Tells whether a cylinder of {@code radius} that stands on {@code floor} can be carried from a to b:
     * no solid that meets the open stretch (floor + step, floor + body height), for a movable one (floor, floor +
     * body height), and no edge of the world, comes nearer to the line than the radius.
     */
    public boolean fits(Line line, double floor, double radius) {
        return insideWorld(line.ax(), line.ay(), radius)
                && insideWorld(line.bx(), line.by(), radius)
                && clearsObstacles(line, floor, radius)
                && clearsGround(line, floor, radius);
    }

    /** Returns the radius in metres of the bounding volume of an ability. */
    public double radius(Ability ability) {
        return ability == Ability.SIDESTEP
                ? actor.sidestep().orElseThrow().radius()
                : actor.walk().radius();
    }

    /** Tells whether the foot disc, carried along the line, rests on {@code floor} everywhere. */
    public boolean rests(Line line, double floor) {
        return rests(line, floor, 0);
    }

    /** Tells whether the foot disc, carried along the line, is nowhere over a drop or rise of more than a step. */
    public boolean isSupported(Line line, double floor) {
        return rests(line, floor, actor.stepHeight());
    }

    private boolean rests(Line line, double floor, double tolerance) {
        double reach = floor + actor.stepHeight() + SLACK;
        return !floors.meets(
                line,
                actor.footRadius() - SLACK,
                (x, y) -> Math.abs(floors.floorAt(x, y, reach) - floor) > tolerance + SLACK);
    }

    /** Returns the elevation of the floor at a point: the highest immovable top not above {@code floor} plus a step. */
    public double floorAt(double x, double y, double floor) {
        return floors.floorAt(x, y, floor + actor.stepHeight() + SLACK);
    }

    /** Returns the elevation of the floor at a point that can be stepped to from {@code floor}, else {@code floor} itself. */
    public double floorUnder(Point at, double floor) {
        double under = floorAt(at.x(), at.y(), floor);
        return under < floor - actor.stepHeight() - SLACK ? floor : under;
    }

    private boolean insideWorld(double x, double y, double radius) {
        double least = radius - SLACK;
        return x >= least && y >= least && world.width() - x >= least && world.depth() - y >= least;
    }

    private boolean clearsObstacles(Line line, double floor, double radius) {
        double high = floor + actor.bodyHeight();
        Box box = line.bounds().grown(radius);
        for (Obstacle o : obstacles) {
            if (o.top() > low(o, floor) + SLACK
                    && o.offset() < high - SLACK
                    && o.outline().bounds().meets(box)
                    && isNear(o.outline(), line, radius)) {
                return false;
            }
        }
        return true;
    }

    /** Returns from where on an obstacle is in the way: nobody treads on a movable one, however low. */
    private double low(Obstacle o, double floor) {
        return o.movable() ? floor : floor + actor.stepHeight();
    }

    /**
     * Tells whether the ground, a wall for someone down in a ditch, keeps {@code radius} from the line where
     * it is higher than a step above {@code floor}.
     */
    public boolean clearsGround(Line line, double floor, double radius) {
        double low = floor + actor.stepHeight() + SLACK;
        return low >= 0 || !floors.meets(line, radius - SLACK, (x, y) -> floors.groundAt(x, y) > low);
    }

    /** Tells whether the line enters the polygon or comes nearer to it than the radius. */
    private static boolean isNear(Polygon polygon, Line line, double radius) {
        double least = radius - SLACK;
        return polygon.contains(line.ax(), line.ay())
                || polygon.contains(line.bx(), line.by())
                || (least > 0 ? line.distance(polygon) < least : line.crosses(polygon));
    }

    /**
     * Returns the obstacles that a body of walking radius on {@code floor} would meet on its way along the
     * line, highest top first (ties: document order).
     */
    public List<Obstacle> inTheWay(Line line, double floor) {
        double high = floor + actor.bodyHeight();
        double radius = Math.max(actor.walk().radius(), SLACK);
        List<Obstacle> met = new ArrayList<>();
        for (Obstacle o : obstacles) {
            if (o.top() > low(o, floor) + SLACK && o.offset() < high - SLACK && isNear(o.outline(), line, radius)) {
                met.add(o);
            }
        }
        met.sort(Comparator.comparingDouble(Obstacle::top).reversed());
        return met;
    }

    /** Returns the elevation of the lowest underside above {@code floor} within walking radius of the line, +∞ if open. */
    public double ceiling(Line line, double floor) {
        double least = Double.POSITIVE_INFINITY;
        double radius = Math.max(actor.walk().radius(), SLACK);
        for (Obstacle o : obstacles) {
            if (o.offset() >= floor && o.offset() < least && isNear(o.outline(), line, radius)) {
                least = o.offset();
            }
        }
        return least;
    }
}
