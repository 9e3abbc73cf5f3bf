package troupe.unified.motion;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.geometry.Segments;
import troupe.unified.body.SweptBody;
import troupe.unified.manipulation.Transfer;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;

/**
 * Holds how an obstacle travels and the actor that moves it, measured by the metres that the farthest point of
 * the two travels, so that at a fixed speed nothing is faster than that. Between two poses of the lattice
 * the obstacle is shifted, or turned about its centroid, evenly; moves that go on as before are one. With a
 * grip the actor moves rigidly with it and at last steps to the centre of its cell; without one it stands.
 * Where the floor under the actor changes from one pose to the next its feet go up or down evenly.
 * Immutable.
 */
final class Haul {
    /** Lines that stand for an arc of the actor's way leave it by at most so many metres. */
    private static final double SAGITTA = 1e-3;

    private static final double SAME = 1e-9;

    private final Movable movable;
    private final boolean gripped;
    private final Point start;
    private final Point end;
    /** The poses between which the motion is even, with headings that do not jump. */
    private final List<Pose> poses = new ArrayList<>();
    /** Metres from the beginning to each pose. */
    private final double[] metres;
    /** The elevation of the actor's feet at each pose. */
    private final double[] floors;

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
        this.start = new Point(from.x(), from.y());
        this.end = new Point(to.x(), to.y());
        List<Double> heights = new ArrayList<>();
        LatticePose before = null;
        for (LatticePose at : transfer.poses()) {
            Pose pose = before == null ? movable.pose(at) : next(before, at);
            double last = before == null ? from.floor() : heights.get(heights.size() - 1);
            double height = before == null || !gripped ? from.floor() : body.floorUnder(rigid(pose), last);
            if (goesOn(heights, pose, height)) {
                poses.remove(poses.size() - 1);
                heights.remove(heights.size() - 1);
            }
            poses.add(pose);
            heights.add(height);
            before = at;
        }
        heights.set(heights.size() - 1, to.floor());
        floors = heights.stream().mapToDouble(Double::doubleValue).toArray();
        metres = travelled();
        hauled = metres[metres.length - 1];
        double rest = rigid(poses.get(poses.size() - 1)).distance(end.x(), end.y());
        length = hauled + (gripped && rest > SAME ? rest : 0);
    }

    /** Returns the pose after the last one; the heading goes on from there. */
    private Pose next(LatticePose before, LatticePose at) {
        int turned = Math.floorMod(at.k() - before.k(), movable.headings());
        int turns = turned <= 1 ? turned : -1;
        Pose pose = movable.pose(at);
        double heading = poses.get(poses.size() - 1).headingRad();
        return new Pose(pose.x(), pose.y(), heading + turns * movable.turn());
    }

    /** Tells whether the step to a pose goes on as the step before it did, on one floor. */
    private boolean goesOn(List<Double> heights, Pose pose, double height) {
        int last = poses.size() - 1;
        if (last < 1 || height != heights.get(last) || height != heights.get(last - 1)) {
            return false;
        }
        Pose a = poses.get(last - 1);
        Pose b = poses.get(last);
        double dx = b.x() - a.x();
        double dy = b.y() - a.y();
        double ex = pose.x() - b.x();
        double ey = pose.y() - b.y();
        double turn = b.headingRad() - a.headingRad();
        double more = pose.headingRad() - b.headingRad();
        return turn == 0 && more == 0
                ? Math.abs(dx * ey - dy * ex) < SAME * movable.cell() && dx * ex + dy * ey > 0
                : turn * more > 0;
    }

    /** Returns for each pose the metres that the farthest point has travelled by then. */
    private double[] travelled() {
        double lever = gripped ? movable.centroid().distance(start.x(), start.y()) : 0;
        double arm = Math.max(movable.farthest(), lever);
        double[] sums = new double[poses.size()];
        for (int i = 1; i < sums.length; i++) {
            Pose a = poses.get(i - 1);
            Pose b = poses.get(i);
            double shift = new Point(a.x(), a.y()).distance(b.x(), b.y());
            sums[i] = sums[i - 1] + shift + arm * Math.abs(b.headingRad() - a.headingRad());
        }
        return sums;
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

    /**
     * Returns the pose of the obstacle's centroid; the heading is 0 as drawn and grows and falls without a jump. Cost
     * O(log poses).
     */
    Pose obstacle(double along) {
        if (along >= hauled) {
            return poses.get(poses.size() - 1);
        }
        int i = next(along);
        Pose a = poses.get(i - 1);
        Pose b = poses.get(i);
        double share = share(i, along);
        return new Pose(
                a.x() + share * (b.x() - a.x()),
                a.y() + share * (b.y() - a.y()),
                a.headingRad() + share * (b.headingRad() - a.headingRad()));
    }

    /** Returns the first pose after the beginning that lies beyond {@code along} metres, {@code along < hauled}. */
    private int next(double along) {
        int low = 1;
        int high = metres.length - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (metres[middle] <= along) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private double share(int i, double along) {
        return (along - metres[i - 1]) / (metres[i] - metres[i - 1]);
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
        int last = floors.length - 1;
        if (!gripped || along <= 0) {
            return new double[] {start.x(), start.y(), floors[0]};
        }
        if (along >= length) {
            return new double[] {end.x(), end.y(), floors[last]};
        }
        Point at = rigid(obstacle(along));
        if (along >= hauled) {
            double share = (along - hauled) / (length - hauled);
            return new double[] {at.x() + share * (end.x() - at.x()), at.y() + share * (end.y() - at.y()), floors[last]
            };
        }
        int i = next(along);
        return new double[] {at.x(), at.y(), floors[i - 1] + share(i, along) * (floors[i] - floors[i - 1])};
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

    /** Returns the way of the actor's feet, {@code x, y, z}: its corners, and enough points on its arcs; at least two. */
    List<double[]> points() {
        List<double[]> points = new ArrayList<>();
        points.add(actor(0));
        for (int i = 1; gripped && i < metres.length; i++) {
            int pieces = pieces(i);
            for (int k = 1; k <= pieces; k++) {
                points.add(actor(metres[i - 1] + k * (metres[i] - metres[i - 1]) / pieces));
            }
        }
        if (points.size() == 1 || length > hauled) {
            points.add(actor(length));
        }
        return points;
    }

    /** Returns into how many lines the actor's way to a pose is cut. */
    private int pieces(int i) {
        double turn = Math.abs(poses.get(i).headingRad() - poses.get(i - 1).headingRad());
        double lever = movable.centroid().distance(start.x(), start.y());
        double flat = 2 * StrictMath.acos(Math.max(0, 1 - SAGITTA / Math.max(lever, SAGITTA)));
        return (int) Math.max(1, Math.ceil(turn / flat));
    }
}
