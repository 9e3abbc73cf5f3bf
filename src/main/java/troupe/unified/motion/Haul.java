package troupe.unified.motion;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.geometry.Segments;
import troupe.unified.body.SweptBody;
import troupe.unified.manipulation.LatticePose;
import troupe.unified.manipulation.Movable;
import troupe.unified.manipulation.Transfer;

/**
 * Holds how an obstacle travels and the actor that moves it, measured by the metres that the farthest point of
 * the two travels, so that at a fixed speed nothing is faster than that. Between two poses of the lattice
 * the obstacle is shifted, or turned about its centroid, evenly. With a grip the actor moves rigidly with it and at last
 * steps to the centre of its cell; without one it stands. Immutable.
 */
final class Haul {
    private final Movable movable;
    private final boolean gripped;
    private final SweptBody body;
    private final List<Pose> poses = new ArrayList<>();
    private final List<Double> metres = new ArrayList<>();
    private final Point start;
    private final Point end;
    private final double floor;
    private final double endFloor;
    private final double hauled;
    private final double length;

    /** Where a haul begins and ends for the actor: the centres of its cells, with their floors. */
    record Stand(double x, double y, double floor) {}

    /**
     * Lays out a haul.
     *
     * @param body tells the floors where the actor passes
     */
    Haul(Movable movable, Transfer transfer, Stand from, Stand to, SweptBody body) {
        this.movable = movable;
        this.gripped = transfer.gripped();
        this.body = body;
        this.start = new Point(from.x(), from.y());
        this.end = new Point(to.x(), to.y());
        this.floor = from.floor();
        this.endFloor = to.floor();
        double lever = gripped ? movable.centroid().distance(start.x(), start.y()) : 0;
        double arm = Math.max(movable.farthest(), lever);
        double sum = 0;
        double heading = 0;
        LatticePose before = null;
        for (LatticePose at : transfer.poses()) {
            if (before != null) {
                int turned = Math.floorMod(at.k() - before.k(), movable.headings());
                heading += turned == 0 ? 0 : turned == 1 ? movable.turn() : -movable.turn();
                Pose here = movable.pose(at);
                Pose last = poses.get(poses.size() - 1);
                double shifted = new Point(here.x(), here.y()).distance(last.x(), last.y());
                sum += turned == 0 ? shifted : arm * movable.turn();
            }
            Pose pose = movable.pose(at);
            poses.add(new Pose(pose.x(), pose.y(), heading));
            metres.add(sum);
            before = at;
        }
        this.hauled = sum;
        Point let = rigid(poses.get(poses.size() - 1));
        this.length = sum + (gripped ? let.distance(end.x(), end.y()) : 0);
    }

    /** Returns the length in metres of the farthest point's travel. */
    double length() {
        return length;
    }

    /** Returns the obstacle that is moved. */
    Movable movable() {
        return movable;
    }

    /** Tells whether the actor holds it. */
    boolean isGripped() {
        return gripped;
    }

    /** Returns the pose of the obstacle's centroid; the heading is 0 as drawn and grows and falls without a jump. */
    Pose obstacle(double along) {
        int last = poses.size() - 1;
        if (along >= hauled) {
            return poses.get(last);
        }
        int i = 1;
        while (i < last && metres.get(i) <= along) {
            i++;
        }
        Pose a = poses.get(i - 1);
        Pose b = poses.get(i);
        double share = (along - metres.get(i - 1)) / (metres.get(i) - metres.get(i - 1));
        return new Pose(
                a.x() + share * (b.x() - a.x()),
                a.y() + share * (b.y() - a.y()),
                a.headingRad() + share * (b.headingRad() - a.headingRad()));
    }

    /** Returns where the actor is carried to when the obstacle is at a pose. */
    private Point rigid(Pose pose) {
        double dx = start.x() - movable.centroid().x();
        double dy = start.y() - movable.centroid().y();
        double cos = StrictMath.cos(pose.headingRad());
        double sin = StrictMath.sin(pose.headingRad());
        return new Point(pose.x() + cos * dx - sin * dy, pose.y() + sin * dx + cos * dy);
    }

    /** Returns {@code x, y, z} of the actor's feet. */
    double[] actor(double along) {
        if (!gripped || along <= 0) {
            return new double[] {start.x(), start.y(), floor};
        }
        if (along >= length) {
            return new double[] {end.x(), end.y(), endFloor};
        }
        Point at = rigid(obstacle(along));
        if (along > hauled) {
            double share = (along - hauled) / (length - hauled);
            at = new Point(at.x() + share * (end.x() - at.x()), at.y() + share * (end.y() - at.y()));
        }
        return new double[] {at.x(), at.y(), body.floorAt(at.x(), at.y(), Math.max(floor, endFloor))};
    }

    /** Returns the heading in radians of an actor that faces what it moves: its hold, or without a grip the centroid. */
    double facing(double along) {
        Pose pose = obstacle(along);
        if (!gripped) {
            return StrictMath.atan2(pose.y() - start.y(), pose.x() - start.x());
        }
        Point hold = hold();
        return Motion.wrapped(StrictMath.atan2(hold.y() - start.y(), hold.x() - start.x()) + pose.headingRad());
    }

    /** Returns the point of the outline that is nearest to the actor where the haul begins. */
    private Point hold() {
        Polygon outline = movable.outline(LatticePose.HOME);
        Point nearest = movable.centroid();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            Point on = Segments.nearest(start.x(), start.y(), outline.x(j), outline.y(j), outline.x(i), outline.y(i));
            double distance = on.distance(start.x(), start.y());
            if (distance < least) {
                least = distance;
                nearest = on;
            }
        }
        return nearest;
    }

    /** Returns the way of the actor's feet, {@code x, y, z}, at the poses of the lattice; at least two points. */
    List<double[]> points() {
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i < (gripped ? poses.size() : 1); i++) {
            points.add(actor(metres.get(i)));
        }
        points.add(actor(length));
        return points;
    }
}
