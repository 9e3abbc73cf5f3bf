package troupe.unified.obstacle;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Line;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.body.SweptBody;

/**
 * Tells whether the body of an actor that holds an obstacle has room along a line: no other obstacle that
 * meets its stretch, no edge of the world and no wall of a ditch comes nearer than the radius asked for.
 * The stretch begins a step above the floor, for movable obstacles at the floor. Used by one thread at a
 * time; allocates nothing once the neighbourhood is known, except in ditches.
 */
final class BodyRoom {
    private static final double SLACK = SweptBody.SLACK;

    private final Actor actor;
    private final Obstacle[] obstacles;
    private final NearEdges edges;
    private final Scene scene;
    private final double reach;
    private SweptBody ground;

    /**
     * Collects what can be in the way.
     *
     * @param held the number of the obstacle that is held and so not in the way
     * @param reach the longest line that will be asked for, in metres
     */
    BodyRoom(Surroundings surroundings, int held, Actor actor, double reach) {
        this.actor = actor;
        List<Obstacle> others = new ArrayList<>();
        List<Polygon> outlines = new ArrayList<>();
        for (int n = 0; n < surroundings.size(); n++) {
            if (n != held) {
                others.add(surroundings.scene().obstacles().get(n));
                outlines.add(surroundings.outline(n));
            }
        }
        World world = surroundings.scene().world();
        outlines.add(Polygon.rectangle(0, 0, world.width(), world.depth()));
        this.obstacles = others.toArray(new Obstacle[0]);
        this.edges = new NearEdges(world, outlines, actor.walk().radius() + reach + SLACK);
        this.scene = surroundings.scene();
        this.reach = reach;
    }

    /** Tells whether it was made for this actor and for lines of this length. */
    boolean serves(Actor other, double length) {
        return actor.equals(other) && length <= reach;
    }

    /** Tells whether a body on {@code floor} that can stand at a keeps {@code least} metres on its way to b. */
    boolean isFree(double ax, double ay, double bx, double by, double floor, double least) {
        double margin = Math.max(least, 0);
        double squared = margin * margin;
        double minX = Math.min(ax, bx) - margin;
        double minY = Math.min(ay, by) - margin;
        double maxX = Math.max(ax, bx) + margin;
        double maxY = Math.max(ay, by) + margin;
        for (int e : edges.near(ax, ay)) {
            if (edges.meetsBox(e, minX, minY, maxX, maxY) && meets(edges.owner(e), floor)) {
                double distance =
                        Segments.distanceSquared(ax, ay, bx, by, edges.ax(e), edges.ay(e), edges.bx(e), edges.by(e));
                if (distance < squared || distance == 0) {
                    return false;
                }
            }
        }
        return floor + actor.stepHeight() >= -SLACK || clearsGround(new Line(ax, ay, bx, by), floor, least);
    }

    private boolean clearsGround(Line line, double floor, double least) {
        if (ground == null) {
            ground = new SweptBody(scene, actor);
        }
        return ground.clearsGround(line, floor, least + SLACK);
    }

    /** Tells whether a point is inside of an obstacle that a body on {@code floor} would meet. Cost O(obstacles). */
    boolean isInside(double x, double y, double floor) {
        for (int n = 0; n < obstacles.length; n++) {
            if (meets(n, floor) && edges.outline(n).contains(x, y)) {
                return true;
            }
        }
        return false;
    }

    /** Tells whether an outline is in the way of a body on a floor: the world's edge always is. */
    private boolean meets(int owner, double floor) {
        if (owner == obstacles.length) {
            return true;
        }
        Obstacle o = obstacles[owner];
        double low = o.movable() ? floor : floor + actor.stepHeight();
        return o.top() > low + SLACK && o.offset() < floor + actor.bodyHeight() - SLACK;
    }

    /** Returns a lower bound on the distance in metres from a point to anything in the way on a floor, at most {@code most}. */
    double distance(double x, double y, double floor, double most) {
        if (floor + actor.stepHeight() < -SLACK) {
            return 0;
        }
        double least = most * most;
        for (int e : edges.near(x, y)) {
            if (edges.meetsBox(e, x - most, y - most, x + most, y + most) && meets(edges.owner(e), floor)) {
                least = Math.min(
                        least, Segments.distanceSquared(x, y, edges.ax(e), edges.ay(e), edges.bx(e), edges.by(e)));
            }
        }
        return Math.sqrt(least) - SLACK;
    }
}
