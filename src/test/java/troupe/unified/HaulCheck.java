package troupe.unified;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Follows the obstacles that a run moves with code of its own: where they stand at any time, that they meet
 * nothing else and stay in the world, and that they stay on what supports them.
 */
final class HaulCheck {
    private static final double SLACK = 1e-6;

    /** Between two frames a straight line cuts the corners of the motion by less than this many metres. */
    private static final double CUT = 0.008;

    private static final int PER_EDGE = 16;
    private static final int GRID = 16;

    private final Scene scene;
    private final Frames frames;
    private final String which;

    /** The first channel of each obstacle, -1 for those that are not moved. */
    private final int[] channels;

    HaulCheck(Run run, String which) {
        this.scene = run.scene();
        this.frames = run.frames();
        this.which = which;
        this.channels = new int[scene.obstacles().size()];
        List<Channel> all = frames.channels();
        for (int n = 0; n < channels.length; n++) {
            String id = scene.obstacles().get(n).id();
            channels[n] = -1;
            for (int c = 0; c < all.size(); c++) {
                if (all.get(c).owner().equals(id) && all.get(c).name().equals("x")) {
                    channels[n] = c;
                }
            }
        }
    }

    /** Returns the obstacles where they stand at a frame and a share of the way to the next. */
    List<Obstacle> at(int frame, double share) {
        List<Obstacle> now = new ArrayList<>();
        for (int n = 0; n < channels.length; n++) {
            Obstacle o = scene.obstacles().get(n);
            now.add(channels[n] < 0 ? o : o.withOutline(placed(o.outline(), pose(n, frame, share))));
        }
        return now;
    }

    private Pose pose(int n, int frame, double share) {
        double[] value = new double[3];
        for (int c = 0; c < 3; c++) {
            double a = frames.value(frame, channels[n] + c, 0);
            double b = frames.value(Math.min(frame + 1, frames.count() - 1), channels[n] + c, 0);
            value[c] = a + share * (b - a);
        }
        return new Pose(value[0], value[1], value[2]);
    }

    private static Polygon placed(Polygon p, Pose pose) {
        Point c = p.centroid();
        double[] xs = new double[p.size()];
        double[] ys = new double[p.size()];
        for (int i = 0; i < xs.length; i++) {
            double dx = p.x(i) - c.x();
            double dy = p.y(i) - c.y();
            xs[i] = pose.x() + Math.cos(pose.headingRad()) * dx - Math.sin(pose.headingRad()) * dy;
            ys[i] = pose.y() + Math.sin(pose.headingRad()) * dx + Math.cos(pose.headingRad()) * dy;
        }
        return new Polygon(xs, ys);
    }

    /** Fails if a moved obstacle meets another, leaves the world or hangs over its support. */
    void check(int frame, double share) {
        List<Obstacle> now = at(frame, share);
        double slack = share == 0 ? SLACK : CUT;
        for (int n = 0; n < channels.length; n++) {
            if (channels[n] < 0) {
                continue;
            }
            Obstacle moved = now.get(n);
            String name = which + ", frame " + (frame + share) + ": " + moved.id();
            for (int i = 0; i < moved.outline().size(); i++) {
                double x = moved.outline().x(i);
                double y = moved.outline().y(i);
                if (x < -slack
                        || y < -slack
                        || x > scene.world().width() + slack
                        || y > scene.world().depth() + slack) {
                    fail(name + " leaves the world at (" + x + ", " + y + ")");
                }
            }
            for (int k = 0; k < now.size(); k++) {
                Obstacle other = now.get(k);
                boolean meet = other.top() > moved.offset() + SLACK && other.offset() < moved.top() - SLACK;
                if (k != n
                        && meet
                        && (enters(moved.outline(), other.outline(), slack)
                                || enters(other.outline(), moved.outline(), slack))) {
                    fail(name + " meets " + other.id());
                }
            }
            if (rests(n, frame)) {
                supported(name, n, pose(n, frame, share), moved);
            }
        }
    }

    /** Tells whether an obstacle stands still from a frame to the next; support is asked for where it does, and at each pose. */
    private boolean rests(int n, int frame) {
        return pose(n, frame, 0).equals(pose(n, frame, 1));
    }

    /** Tells whether some point of one outline lies deeper than {@code slack} inside the other. */
    private static boolean enters(Polygon a, Polygon b, double slack) {
        if (!a.bounds().meets(b.bounds())) {
            return false;
        }
        for (int i = 0; i < a.size(); i++) {
            int j = (i + 1) % a.size();
            for (int k = 0; k < PER_EDGE; k++) {
                double share = k / (double) PER_EDGE;
                double x = a.x(i) + share * (a.x(j) - a.x(i));
                double y = a.y(i) + share * (a.y(j) - a.y(i));
                if (b.contains(x, y) && b.distanceToOutline(x, y) > slack) {
                    return true;
                }
            }
        }
        return false;
    }

    private void supported(String name, int n, Pose pose, Obstacle moved) {
        supported(scene, name, scene.obstacles().get(n).outline(), pose, moved.offset());
    }

    /** Fails if not even the centre, or three fifths, of a footprint at a pose lie over something at a height. */
    static void supported(Scene scene, String name, Polygon home, Pose pose, double height) {
        Point c = home.centroid();
        if (!carried(scene, pose.x(), pose.y(), height)) {
            fail(name + " has nothing under its centre at (" + pose.x() + ", " + pose.y() + ")");
        }
        Box box = home.bounds();
        int inside = 0;
        int over = 0;
        for (int i = 0; i < GRID * GRID; i++) {
            double x = box.minX() + (i % GRID + 0.5) / GRID * (box.maxX() - box.minX());
            double y = box.minY() + (i / GRID + 0.5) / GRID * (box.maxY() - box.minY());
            if (home.contains(x, y)) {
                inside++;
                double dx = x - c.x();
                double dy = y - c.y();
                double px = pose.x() + Math.cos(pose.headingRad()) * dx - Math.sin(pose.headingRad()) * dy;
                double py = pose.y() + Math.sin(pose.headingRad()) * dx + Math.cos(pose.headingRad()) * dy;
                over += carried(scene, px, py, height) ? 1 : 0;
            }
        }
        if (over < 0.6 * inside - 1) {
            fail(name + " rests on " + over + " of " + inside + " parts");
        }
    }

    private static boolean carried(Scene scene, double x, double y, double height) {
        double ground = 0;
        for (Ditch d : scene.ditches()) {
            ground = d.outline().contains(x, y) ? Math.min(ground, -d.depth()) : ground;
        }
        boolean on = Math.abs(ground - height) < SLACK;
        for (Obstacle o : scene.obstacles()) {
            on |= !o.movable()
                    && Math.abs(o.top() - height) < SLACK
                    && o.outline().contains(x, y);
        }
        return on;
    }
}
