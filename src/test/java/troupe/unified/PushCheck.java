package troupe.unified;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.grid.region.Region;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.unified.manipulation.Transfer;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.reference.Shapes;
import troupe.unified.search.JourneyPath;

/**
 * Replays what a path moves, pose by pose and exactly between the poses, with code of its own: the obstacle
 * meets nothing and stays in the world, and with a grip the body of the actor, which is carried along
 * rigidly, keeps its radius. Then it compares the frames with that motion.
 */
final class PushCheck {
    private static final double SLACK = 1e-6;

    /** With a grip a turn is planned on chords that leave the arc by 0.1 mm. */
    private static final double TURNED = 1.01e-4;

    private static final int SAMPLES = 8;
    private static final int ROUND = 24;

    private final Scene scene;
    private final Actor actor;
    private final Journey journey;
    private final Frames frames;
    private final String which;
    private final List<Obstacle> now;

    private PushCheck(Run run, Actor actor, String which) {
        this.scene = run.scene();
        this.actor = actor;
        this.journey = (Journey) scene.task(run.task()).orElseThrow();
        this.frames = run.frames();
        this.which = which;
        this.now = new ArrayList<>(scene.obstacles());
    }

    /** Fails if anything that the path moves, or the actor with it, meets something, or the run shows another motion. */
    static void assertFree(Run run, Actor actor, JourneyPath path, String which) {
        PushCheck check = new PushCheck(run, actor, which);
        List<Run.Leg> legs = run.legs().stream()
                .filter(leg -> leg.ability().equals(Ability.MOVE.key()))
                .toList();
        assertEquals(path.pushes().size(), legs.size(), which);
        JourneyPath.Way before = null;
        int push = 0;
        for (JourneyPath.Part part : path.parts()) {
            if (part instanceof JourneyPath.Way way) {
                before = way;
            } else if (part instanceof JourneyPath.Push moved) {
                check.push(moved.transfer(), before.region(), legs.get(push));
                push++;
            }
        }
    }

    /** One obstacle on its way: its poses with headings that do not jump, and the actor that may hold it. */
    private record Carried(Obstacle obstacle, List<Pose> poses, boolean gripped, Point start, Point end, double floor) {

        Pose between(int n, double share) {
            Pose a = poses.get(n - 1);
            Pose b = poses.get(n);
            return new Pose(
                    a.x() + share * (b.x() - a.x()),
                    a.y() + share * (b.y() - a.y()),
                    a.headingRad() + share * (b.headingRad() - a.headingRad()));
        }

        Point carriedTo(Pose pose, double x, double y) {
            Point c = obstacle.outline().centroid();
            double cos = Math.cos(pose.headingRad());
            double sin = Math.sin(pose.headingRad());
            return new Point(
                    pose.x() + cos * (x - c.x()) - sin * (y - c.y()), pose.y() + sin * (x - c.x()) + cos * (y - c.y()));
        }

        Point actor(Pose pose) {
            return gripped ? carriedTo(pose, start.x(), start.y()) : start;
        }

        Polygon outline(Pose pose) {
            Polygon p = obstacle.outline();
            double[] xs = new double[p.size()];
            double[] ys = new double[p.size()];
            for (int i = 0; i < xs.length; i++) {
                Point at = carriedTo(pose, p.x(i), p.y(i));
                xs[i] = at.x();
                ys[i] = at.y();
            }
            return new Polygon(xs, ys);
        }

        Pose last() {
            return poses.get(poses.size() - 1);
        }
    }

    private void push(Transfer transfer, Region region, Run.Leg leg) {
        int number = transfer.obstacle();
        Obstacle obstacle = scene.obstacles().get(number);
        assertEquals(obstacle.id(), leg.what(), which);
        Carried carried = new Carried(
                obstacle,
                poses(obstacle, transfer.poses()),
                transfer.gripped(),
                new Point(region.x(transfer.from()), region.y(transfer.from())),
                new Point(region.x(transfer.to()), region.y(transfer.to())),
                region.elevation(transfer.from()));
        double floor = carried.floor();
        for (Pose pose : carried.poses()) {
            HaulCheck.supported(scene, which + ": " + obstacle.id(), obstacle.outline(), pose, obstacle.offset());
        }
        for (int n = 1; n < carried.poses().size(); n++) {
            double turn = carried.poses().get(n).headingRad()
                    - carried.poses().get(n - 1).headingRad();
            for (int k = 0; k <= SAMPLES; k++) {
                Pose pose = carried.between(n, k / (double) SAMPLES);
                obstacle(number, carried.outline(pose), n);
                now.set(number, obstacle.withOutline(carried.outline(pose)));
                if (carried.gripped()) {
                    Point at = carried.actor(pose);
                    floor = floor(at, floor);
                    body(at, floor, turn == 0 ? SLACK : TURNED, "pose " + n + " of " + obstacle.id());
                }
            }
        }
        Point let = carried.actor(carried.last());
        for (int k = 0; k <= SAMPLES; k++) {
            double share = k / (double) SAMPLES;
            Point at = new Point(
                    let.x() + share * (carried.end().x() - let.x()),
                    let.y() + share * (carried.end().y() - let.y()));
            if (carried.gripped()) {
                body(at, floor, SLACK, "letting go of " + obstacle.id());
            }
        }
        frames(carried, leg);
    }

    private List<Pose> poses(Obstacle obstacle, List<LatticePose> lattice) {
        int headings = journey.headings();
        Point c = obstacle.outline().centroid();
        double cell = scene.world().cell();
        List<Pose> poses = new ArrayList<>();
        int unwound = 0;
        for (int n = 0; n < lattice.size(); n++) {
            LatticePose at = lattice.get(n);
            if (n > 0) {
                LatticePose last = lattice.get(n - 1);
                int turned = Math.floorMod(at.k() - last.k(), headings);
                boolean shifts = at.i() != last.i() || at.j() != last.j();
                boolean one = Math.abs(at.i() - last.i()) <= 1 && Math.abs(at.j() - last.j()) <= 1;
                boolean single = turned == 0 ? shifts && one : !shifts && (turned == 1 || turned == headings - 1);
                assertTrue(single, which + ": " + last + " to " + at + " is no single move");
                unwound += turned == 0 ? 0 : turned == 1 ? 1 : -1;
            } else {
                assertEquals(LatticePose.HOME, at, which);
            }
            poses.add(new Pose(c.x() + at.i() * cell, c.y() + at.j() * cell, unwound * 2 * Math.PI / headings));
        }
        return poses;
    }

    private void obstacle(int number, Polygon outline, int n) {
        Obstacle moved = now.get(number);
        String name = which + ", move " + n + " of " + moved.id();
        if (outline.bounds().minX() < -SLACK
                || outline.bounds().minY() < -SLACK
                || outline.bounds().maxX() > scene.world().width() + SLACK
                || outline.bounds().maxY() > scene.world().depth() + SLACK) {
            fail(name + " leaves the world");
        }
        for (int k = 0; k < now.size(); k++) {
            Obstacle other = now.get(k);
            boolean meet = other.top() > moved.offset() + SLACK && other.offset() < moved.top() - SLACK;
            if (k != number
                    && meet
                    && other.outline().bounds().meets(outline.bounds())
                    && Shapes.overlap(other.outline(), outline, SLACK)) {
                fail(name + " meets " + other.id());
            }
        }
    }

    /** Returns the highest floor at a point that is no more than a step above the one before. */
    private double floor(Point at, double before) {
        double floor = ground(at.x(), at.y());
        for (Obstacle o : scene.obstacles()) {
            boolean reached = !o.movable() && o.top() <= before + actor.stepHeight() + SLACK;
            floor = reached && o.outline().contains(at.x(), at.y()) ? Math.max(floor, o.top()) : floor;
        }
        return Math.abs(floor - before) <= actor.stepHeight() + SLACK ? floor : before;
    }

    private double ground(double x, double y) {
        double ground = 0;
        for (Ditch d : scene.ditches()) {
            ground = d.outline().contains(x, y) ? Math.min(ground, -d.depth()) : ground;
        }
        return ground;
    }

    private void body(Point at, double floor, double slack, String what) {
        double least = actor.walk().radius() - slack;
        String name = which + ", " + what + ": the actor at " + at;
        for (Obstacle o : now) {
            double low = o.movable() ? floor : floor + actor.stepHeight();
            boolean meets = o.top() > low + SLACK && o.offset() < floor + actor.bodyHeight() - SLACK;
            double distance = meets ? Shapes.distance(o.outline(), at.x(), at.y()) : least;
            if (distance < least) {
                fail(name + " is " + distance + " m from " + o.id());
            }
        }
        double edge = Math.min(
                Math.min(at.x(), at.y()),
                Math.min(scene.world().width() - at.x(), scene.world().depth() - at.y()));
        if (edge < least) {
            fail(name + " is " + edge + " m from the edge of the world");
        }
        for (int k = 0; k < ROUND; k++) {
            double x = at.x() + least * Math.cos(2 * Math.PI * k / ROUND);
            double y = at.y() + least * Math.sin(2 * Math.PI * k / ROUND);
            if (ground(x, y) > floor + actor.stepHeight() + SLACK) {
                fail(name + " meets the wall of a ditch");
            }
        }
    }

    /** Compares the frames of a leg with the motion: place, pace, and what the actor looks at. */
    private void frames(Carried carried, Run.Leg leg) {
        int x = frames.channel(carried.obstacle().id(), "x");
        double most = actor.move().orElseThrow().speed() / frames.rate() + 1e-9;
        int begin = (int) Math.ceil(leg.begin() * frames.rate() - 1e-6);
        int end = (int) Math.floor(leg.end() * frames.rate() + 1e-6);
        Pose before = null;
        for (int f = begin; f <= Math.min(end, frames.count() - 1); f++) {
            String name = which + ", frame " + f + ": " + carried.obstacle().id();
            Pose pose = new Pose(frames.value(f, x, 0), frames.value(f, x + 1, 0), frames.value(f, x + 2, 0));
            assertTrue(isOnItsWay(carried, pose), name + " is off its way at " + pose);
            if (before != null) {
                assertTrue(farthest(carried, before, pose) <= most, name + " is too fast");
            }
            Point at = new Point(frames.value(f, 0, 0), frames.value(f, 1, 0));
            Point held = carried.actor(pose);
            boolean lets = isLast(carried, pose) && isBetween(at, held, carried.end());
            assertTrue(at.distance(held.x(), held.y()) < SLACK || carried.gripped() && lets, name + " lost its actor");
            before = pose;
        }
    }

    private static boolean isLast(Carried carried, Pose pose) {
        Pose last = carried.last();
        return Math.abs(pose.x() - last.x())
                        + Math.abs(pose.y() - last.y())
                        + Math.abs(pose.headingRad() - last.headingRad())
                < SLACK;
    }

    private static boolean isBetween(Point p, Point a, Point b) {
        return p.distance(a.x(), a.y()) + p.distance(b.x(), b.y()) < a.distance(b.x(), b.y()) + SLACK;
    }

    private static boolean isOnItsWay(Carried carried, Pose pose) {
        for (int n = 1; n < carried.poses().size(); n++) {
            Pose a = carried.poses().get(n - 1);
            Pose b = carried.poses().get(n);
            double dx = b.x() - a.x();
            double dy = b.y() - a.y();
            double turn = b.headingRad() - a.headingRad();
            double share =
                    ((pose.x() - a.x()) * dx + (pose.y() - a.y()) * dy + (pose.headingRad() - a.headingRad()) * turn)
                            / (dx * dx + dy * dy + turn * turn);
            Pose on = carried.between(n, Math.max(0, Math.min(1, share)));
            double off = Math.abs(on.x() - pose.x())
                    + Math.abs(on.y() - pose.y())
                    + Math.abs(on.headingRad() - pose.headingRad());
            if (off < SLACK) {
                return true;
            }
        }
        return false;
    }

    /** Returns the metres that the fastest of the corners and of an actor with a grip travels from pose to pose. */
    private static double farthest(Carried carried, Pose from, Pose to) {
        Polygon p = carried.obstacle().outline();
        double most = carried.actor(from)
                .distance(carried.actor(to).x(), carried.actor(to).y());
        for (int i = 0; i < p.size(); i++) {
            Point a = carried.carriedTo(from, p.x(i), p.y(i));
            Point b = carried.carriedTo(to, p.x(i), p.y(i));
            most = Math.max(most, a.distance(b.x(), b.y()));
        }
        return most;
    }
}
