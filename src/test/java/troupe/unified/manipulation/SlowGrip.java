package troupe.unified.manipulation;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.unified.obstacle.Grip;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;

/**
 * Says where an actor can walk with an obstacle in its grip, from the definition: its body is looked at
 * moment by moment; only what is too close to tell that way is asked of the code under test.
 */
public final class SlowGrip {
    private static final int MOMENTS = 50;

    /** Where a motion leads, and by how many steps. */
    record Walk(int stand, int straight, int diagonal) {}

    private final Scene scene;
    private final Movable movable;
    private final Region base;
    private final Region without;
    private final Grip exact;
    private final Actor actor;
    private final double armX;
    private final double armY;
    private final int parts;

    public SlowGrip(Scene scene, Movable movable, Region base, int trigger) {
        this.scene = scene;
        this.movable = movable;
        this.base = base;
        this.actor = base.actor();
        this.without = base.without(movable.number());
        this.exact = grip(scene, movable, base, trigger);
        this.armX = base.x(trigger) - movable.centroid().x();
        this.armY = base.y(trigger) - movable.centroid().y();
        double turn = 2 * Math.PI / movable.headings();
        this.parts = Math.max(1, (int) Math.ceil(Math.hypot(armX, armY) * turn / (movable.cell() / 2)));
    }

    /** Makes the code under test for the same question. */
    public static Grip grip(Scene scene, Movable movable, Region base, int trigger) {
        int number = movable.number();
        return new Grip(
                movable,
                new Surroundings(scene),
                base.without(number),
                trigger,
                (pose, stand) -> stands(base.with(number, movable.outline(pose)), stand));
    }

    private Point at(LatticePose pose, double turns) {
        double angle = (pose.k() + turns) * 2 * Math.PI / movable.headings();
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        return new Point(
                movable.centroid().x() + pose.i() * movable.cell() + cos * armX - sin * armY,
                movable.centroid().y() + pose.j() * movable.cell() + sin * armX + cos * armY);
    }

    private int cell(LatticePose pose, double turns) {
        Point home = at(new LatticePose(0, 0, pose.k()), turns);
        GridFrame frame = base.frame();
        int col = (int) Math.floor((home.x() - frame.originX()) / frame.cell() + 1e-9) + pose.i();
        int row = (int) Math.floor((home.y() - frame.originY()) / frame.cell() + 1e-9) + pose.j();
        return col < 0 || row < 0 || col >= frame.cols() || row >= frame.rows() ? -1 : frame.index(col, row);
    }

    private int step(int from, int cell) {
        if (base.cell(from) == cell) {
            return from;
        }
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int count = without.neighbours(from, targets, new int[Region.MAX_NEIGHBOURS]);
        for (int n = 0; n < count; n++) {
            if (targets[n] < without.spanCount() && without.cell(targets[n]) == cell && stands(without, targets[n])) {
                return targets[n];
            }
        }
        return -1;
    }

    private static boolean stands(Region region, int q) {
        return region.open(q) && region.kind(q) == Kind.STABLE && (region.abilities(q) & Ability.WALK.bit()) != 0;
    }

    /** Returns where a move takes the actor, null if it cannot go. */
    Walk walk(SlowInstance.State state, int move) {
        LatticePose pose = state.pose();
        List<Integer> passed = new ArrayList<>(List.of(state.stand()));
        int count = move < 8 ? 1 : parts;
        int straight = 0;
        int diagonal = 0;
        for (int part = 1; part <= count; part++) {
            int from = passed.get(part - 1);
            double turns = move < 8 ? 0 : (move == 8 ? 1.0 : -1.0) * part / parts;
            LatticePose shifted = move < 8
                    ? new LatticePose(pose.i() + GridFrame.dx(move), pose.j() + GridFrame.dy(move), pose.k())
                    : pose;
            int to = step(from, cell(shifted, turns));
            if (to < 0) {
                return null;
            }
            int dx = Math.abs(base.frame().col(base.cell(to)) - base.frame().col(base.cell(from)));
            int dy = Math.abs(base.frame().row(base.cell(to)) - base.frame().row(base.cell(from)));
            straight += dx + dy == 1 ? 1 : 0;
            diagonal += dx + dy == 2 ? 1 : 0;
            passed.add(to);
        }
        return hasRoom(state, move, passed) ? new Walk(passed.get(count), straight, diagonal) : null;
    }

    private boolean hasRoom(SlowInstance.State state, int move, List<Integer> passed) {
        LatticePose pose = state.pose();
        double travel =
                move < 8 ? base.frame().stepLength(move) : Math.hypot(armX, armY) * 2 * Math.PI / movable.headings();
        double slack = move < 8 ? 2e-9 : 2.1e-4;
        double radius = actor.walk().radius();
        double least = Double.POSITIVE_INFINITY;
        for (int n = 0; n <= MOMENTS && least > radius - slack; n++) {
            double t = (double) n / MOMENTS;
            Point at = move < 8 ? at(pose, 0) : at(pose, move == 8 ? t : -t);
            double x = at.x() + (move < 8 ? t * GridFrame.dx(move) * movable.cell() : 0);
            double y = at.y() + (move < 8 ? t * GridFrame.dy(move) * movable.cell() : 0);
            int part = Math.min(passed.size() - 2, (int) (t * (passed.size() - 1)));
            least = Math.min(least, room(x, y, base.elevation(passed.get(part))));
            least = Math.min(least, room(x, y, base.elevation(passed.get(part + 1))));
        }
        if (least < radius - slack || least > radius + travel / MOMENTS) {
            return least > radius;
        }
        exact.choose(state.stand(), pose.i(), pose.j(), pose.k());
        if (move < 8) {
            return exact.canShift(move, exact.shifted(move));
        }
        return exact.turned(move == 8) >= 0 && exact.canTurn(move == 8);
    }

    /** Returns the distance from a point to the nearest thing that a body on a floor would meet but what is held. */
    private double room(double x, double y, double floor) {
        double least = Math.min(
                Math.min(x, y),
                Math.min(scene.world().width() - x, scene.world().depth() - y));
        for (int n = 0; n < scene.obstacles().size(); n++) {
            Obstacle o = scene.obstacles().get(n);
            double low = floor + (o.movable() ? 0 : actor.stepHeight());
            if (n != movable.number() && o.top() > low + 1e-9 && o.offset() < floor + actor.bodyHeight() - 1e-9) {
                least = Math.min(least, o.outline().distance(x, y));
            }
        }
        return least;
    }

    public boolean settles(SlowInstance.State state) {
        Region after = base.with(movable.number(), movable.outline(state.pose()));
        if (!stands(after, state.stand())) {
            return false;
        }
        Point from = at(state.pose(), 0);
        double toX = base.x(state.stand());
        double toY = base.y(state.stand());
        double floor = base.elevation(state.stand());
        Polygon outline = movable.outline(state.pose());
        double least = Double.POSITIVE_INFINITY;
        for (int n = 0; n <= MOMENTS; n++) {
            double x = from.x() + (toX - from.x()) * n / MOMENTS;
            double y = from.y() + (toY - from.y()) * n / MOMENTS;
            least = Math.min(least, room(x, y, floor));
            if (movable.meets(floor, actor.bodyHeight())) {
                least = Math.min(least, outline.distance(x, y));
            }
        }
        double radius = actor.walk().radius();
        if (least < radius - 2e-9 || least > radius + from.distance(toX, toY) / MOMENTS) {
            return least > radius;
        }
        return exact.settles(
                state.stand(), state.pose().i(), state.pose().j(), state.pose().k());
    }
}
