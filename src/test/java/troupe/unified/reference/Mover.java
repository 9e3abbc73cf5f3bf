package troupe.unified.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import troupe.geometry.Polygon;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Knows which moves one obstacle can make among all the others, wherever these stand: whole sweeps, of its
 * triangles against theirs, straight ones exactly and turns by halving the angle until it is decided.
 */
final class Mover {
    private static final double SLACK = 1e-9;
    private static final double LEAST_SWEEP = 1e-11;

    final Obstacle obstacle;
    final double[] centroid;
    final double cell;
    final int headings;
    private final Scene scene;
    private final List<List<double[]>> others = new ArrayList<>();
    private final List<double[]> circles = new ArrayList<>();
    private final List<double[]> triangles;
    private final List<double[]> sample = new ArrayList<>();
    private final double reach;
    private final Map<Pose, boolean[]> allowed = new TreeMap<>();

    /** A pose on the lattice anchored at the obstacle's own. */
    record Pose(int i, int j, int k) implements Comparable<Pose> {
        @Override
        public int compareTo(Pose other) {
            int byI = Integer.compare(i, other.i);
            int byJ = byI != 0 ? byI : Integer.compare(j, other.j);
            return byJ != 0 ? byJ : Integer.compare(k, other.k);
        }
    }

    /**
     * Prepares an obstacle's moves.
     *
     * @param outlines where every obstacle of the scene stands, this one's place not being asked
     */
    Mover(Ground ground, int number, Polygon[] outlines, int headings) {
        this.scene = ground.scene;
        this.obstacle = scene.obstacles().get(number);
        this.centroid = Shapes.centroid(obstacle.outline());
        this.cell = ground.cell;
        this.headings = headings;
        this.triangles = Shapes.triangles(obstacle.outline());
        double farthest = 0;
        for (int i = 0; i < obstacle.outline().size(); i++) {
            farthest = Math.max(
                    farthest,
                    Math.hypot(
                            obstacle.outline().x(i) - centroid[0],
                            obstacle.outline().y(i) - centroid[1]));
        }
        reach = farthest;
        for (int n = 0; n < outlines.length; n++) {
            Obstacle o = scene.obstacles().get(n);
            if (n != number && Ground.meets(o.offset(), o.top(), obstacle.offset(), obstacle.top())) {
                Polygon outline = o.movable() ? outlines[n] : o.outline();
                others.add(Shapes.triangles(outline));
                circles.add(circle(outline));
            }
        }
        fillSample();
    }

    private static double[] circle(Polygon p) {
        double[] c = Shapes.centroid(p);
        double radius = 0;
        for (int i = 0; i < p.size(); i++) {
            radius = Math.max(radius, Math.hypot(p.x(i) - c[0], p.y(i) - c[1]));
        }
        return new double[] {c[0], c[1], radius};
    }

    private void fillSample() {
        Polygon p = obstacle.outline();
        double width = p.bounds().maxX() - p.bounds().minX();
        double depth = p.bounds().maxY() - p.bounds().minY();
        for (int row = 0; row < 16; row++) {
            for (int col = 0; col < 16; col++) {
                double x = p.bounds().minX() + (col + 0.5) / 16 * width;
                double y = p.bounds().minY() + (row + 0.5) / 16 * depth;
                if (Shapes.inside(p, x, y)) {
                    sample.add(new double[] {x, y});
                }
            }
        }
    }

    /** Returns where a point of the obstacle's own pose is carried. */
    double[] carried(Pose pose, double x, double y) {
        return turned(pose.i, pose.j, angle(pose.k), x, y);
    }

    /** Returns where a point is carried by a shift of whole cells and a turn by some angle. */
    double[] turned(int i, int j, double angle, double x, double y) {
        double cos = angle == 0 ? 1 : StrictMath.cos(angle);
        double sin = angle == 0 ? 0 : StrictMath.sin(angle);
        double dx = x - centroid[0];
        double dy = y - centroid[1];
        return new double[] {centroid[0] + i * cell + cos * dx - sin * dy, centroid[1] + j * cell + sin * dx + cos * dy
        };
    }

    double angle(int k) {
        return k * 2 * Math.PI / headings;
    }

    /** Returns the outline at a pose. */
    Polygon outline(Pose pose) {
        Polygon p = obstacle.outline();
        if (pose.i == 0 && pose.j == 0 && pose.k == 0) {
            return p;
        }
        double[] xs = new double[p.size()];
        double[] ys = new double[p.size()];
        for (int i = 0; i < p.size(); i++) {
            double[] at = carried(pose, p.x(i), p.y(i));
            xs[i] = at[0];
            ys[i] = at[1];
        }
        return new Polygon(xs, ys);
    }

    /** Returns the pose after a move: 0 to 7 shifts by a cell, 8 and 9 turn. */
    Pose after(Pose pose, int move) {
        if (move < 8) {
            return new Pose(pose.i + Space.DX[move], pose.j + Space.DY[move], pose.k);
        }
        return new Pose(pose.i, pose.j, Math.floorMod(pose.k + (move == 8 ? 1 : -1), headings));
    }

    /** Tells whether a move has room and ends with support. */
    boolean allows(Pose pose, int move) {
        boolean[] known = allowed.computeIfAbsent(pose, p -> allowed(p));
        return known[move];
    }

    private boolean[] allowed(Pose pose) {
        boolean[] all = new boolean[10];
        List<double[]> there = new ArrayList<>();
        triangles.forEach(t -> there.add(carried(pose, t)));
        for (int move = 0; move < 10; move++) {
            boolean fits = move < 8
                    ? slides(pose, Space.DX[move] * cell, Space.DY[move] * cell, there)
                    : turns(pose, move == 8 ? angle(1) : -angle(1), there);
            all[move] = fits && isSupported(after(pose, move));
        }
        return all;
    }

    private double[] carried(Pose pose, double[] triangle) {
        double[] moved = new double[6];
        for (int i = 0; i < 6; i += 2) {
            double[] at = carried(pose, triangle[i], triangle[i + 1]);
            moved[i] = at[0];
            moved[i + 1] = at[1];
        }
        return moved;
    }

    private boolean inWorld(double x, double y) {
        return x >= -SLACK
                && y >= -SLACK
                && x <= scene.world().width() + SLACK
                && y <= scene.world().depth() + SLACK;
    }

    private boolean slides(Pose pose, double vx, double vy, List<double[]> there) {
        Polygon from = outline(pose);
        for (int i = 0; i < from.size(); i++) {
            if (!inWorld(from.x(i), from.y(i)) || !inWorld(from.x(i) + vx, from.y(i) + vy)) {
                return false;
            }
        }
        double x = centroid[0] + pose.i * cell;
        double y = centroid[1] + pose.j * cell;
        for (int n = 0; n < others.size(); n++) {
            double[] c = circles.get(n);
            if (Shapes.distance(c[0], c[1], x, y, x + vx, y + vy) > c[2] + reach) {
                continue;
            }
            for (double[] t : there) {
                for (double[] other : others.get(n)) {
                    if (Shapes.apart(t, vx, vy, other) < -SLACK) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    private boolean turns(Pose pose, double by, List<double[]> there) {
        double x = centroid[0] + pose.i * cell;
        double y = centroid[1] + pose.j * cell;
        Polygon from = outline(pose);
        for (int i = 0; i < from.size(); i++) {
            if (!arcInWorld(from.x(i) - x, from.y(i) - y, x, y, by)) {
                return false;
            }
        }
        for (int n = 0; n < others.size(); n++) {
            double[] c = circles.get(n);
            if (Math.hypot(c[0] - x, c[1] - y) > c[2] + reach) {
                continue;
            }
            for (double[] t : there) {
                for (double[] other : others.get(n)) {
                    if (hits(t, other, x, y, 0, by)) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** Looks at the ends of an arc and at the points farthest east, north, west and south on it. */
    private boolean arcInWorld(double dx, double dy, double x, double y, double by) {
        double radius = Math.hypot(dx, dy);
        double from = Math.atan2(dy, dx);
        boolean inside =
                inWorld(x + dx, y + dy) && inWorld(x + radius * Math.cos(from + by), y + radius * Math.sin(from + by));
        for (int quarter = -8; quarter <= 8; quarter++) {
            double angle = quarter * Math.PI / 2;
            if (angle > Math.min(from, from + by) && angle < Math.max(from, from + by)) {
                inside &= inWorld(x + radius * Math.round(Math.cos(angle)), y + radius * Math.round(Math.sin(angle)));
            }
        }
        return inside;
    }

    /** Tells whether a triangle that turns about a point overlaps another one between two angles. */
    private boolean hits(double[] triangle, double[] other, double x, double y, double from, double to) {
        double middle = (from + to) / 2;
        double cos = Math.cos(middle);
        double sin = Math.sin(middle);
        double[] turned = new double[6];
        double radius = 0;
        for (int i = 0; i < 6; i += 2) {
            double dx = triangle[i] - x;
            double dy = triangle[i + 1] - y;
            radius = Math.max(radius, Math.hypot(dx, dy));
            turned[i] = x + cos * dx - sin * dy;
            turned[i + 1] = y + sin * dx + cos * dy;
        }
        double apart = Shapes.apart(turned, 0, 0, other);
        double sweep = radius * Math.abs(to - from) / 2;
        if (apart >= sweep || sweep < LEAST_SWEEP) {
            return false;
        }
        return apart < -SLACK || hits(triangle, other, x, y, from, middle) || hits(triangle, other, x, y, middle, to);
    }

    /** Tells whether the centroid and at least 60 % of the footprint lie over what can carry the obstacle. */
    boolean isSupported(Pose pose) {
        if (!carries(centroid[0] + pose.i * cell, centroid[1] + pose.j * cell)) {
            return false;
        }
        int held = 0;
        for (double[] s : sample) {
            double[] at = carried(pose, s[0], s[1]);
            held += carries(at[0], at[1]) ? 1 : 0;
        }
        return 10 * held >= 6 * sample.size();
    }

    private boolean carries(double x, double y) {
        double ground = 0;
        for (troupe.scene.Ditch ditch : scene.ditches()) {
            ground = Shapes.inside(ditch.outline(), x, y) ? Math.min(ground, -ditch.depth()) : ground;
        }
        boolean carries = Math.abs(ground - obstacle.offset()) <= SLACK;
        for (Obstacle o : scene.obstacles()) {
            carries |=
                    !o.movable() && Math.abs(o.top() - obstacle.offset()) <= SLACK && Shapes.inside(o.outline(), x, y);
        }
        return carries;
    }
}
