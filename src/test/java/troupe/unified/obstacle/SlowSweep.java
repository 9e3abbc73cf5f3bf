package troupe.unified.obstacle;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Overlap;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.grid.GridFrame;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.manipulation.Shapes;

/** Looks at a move moment by moment. */
public final class SlowSweep {
    private static final int MOMENTS = 60;

    private final List<Polygon> others = new ArrayList<>();
    private final Movable movable;
    private final World world;

    /** Looks at one obstacle among the others of a scene. */
    public SlowSweep(Scene scene, Movable movable) {
        this.movable = movable;
        this.world = scene.world();
        for (int n = 0; n < scene.obstacles().size(); n++) {
            if (n != movable.number()) {
                others.add(scene.obstacles().get(n).outline());
            }
        }
    }

    /** Tells whether an outline overlaps another obstacle or leaves the world. */
    public boolean overlaps(Polygon outline) {
        return others.stream().anyMatch(o -> Overlap.of(o, outline)) || margin(outline) < 0;
    }

    /** Returns how far the outline stays inside of the world, negative if it does not. */
    private double margin(Polygon outline) {
        var box = outline.bounds();
        return Math.min(
                Math.min(box.minX(), box.minY()), Math.min(world.width() - box.maxX(), world.depth() - box.maxY()));
    }

    private double distance(Polygon outline) {
        double least = margin(outline);
        for (Polygon other : others) {
            least = Math.min(least, Shapes.distance(outline, other));
        }
        return least;
    }

    /** Returns 1 for a move that surely has room, -1 for one that surely has not, 0 if it is too close to tell. */
    public int judge(LatticePose from, int move) {
        double dx = move < 8 ? GridFrame.dx(move) * movable.cell() : 0;
        double dy = move < 8 ? GridFrame.dy(move) * movable.cell() : 0;
        double turn = move < 8 ? 0 : (move == 8 ? 1 : -1) * movable.turn();
        double travel = Math.hypot(dx, dy) + Math.abs(turn) * movable.farthest();
        Pose pose = movable.pose(from);
        Polygon shape = movable.obstacle().outline();
        Point centre = new Point(pose.x(), pose.y());
        if (distance(shape.at(pose)) > travel && !overlaps(shape.at(pose))) {
            return 1;
        }
        boolean close = false;
        for (int n = 0; n <= MOMENTS; n++) {
            double t = (double) n / MOMENTS;
            Polygon outline =
                    shape.at(new Pose(centre.x() + t * dx, centre.y() + t * dy, pose.headingRad() + t * turn));
            if (overlaps(outline)) {
                return -1;
            }
            close |= distance(outline) < travel / MOMENTS;
        }
        return close ? 0 : 1;
    }
}
