package troupe.grid.region.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.grid.CellRuns;
import troupe.grid.layer.Columns;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Cuts the outlines of a scene where they meet each other and keeps the pieces that have different
 * columns on their two sides: the places where a floor or the ground changes. Pieces that two outlines
 * share come twice. The columns are those {@link #ASIDE} metres to the left and to the right of a piece's middle.
 */
public final class Rims {
    /** How far beside a piece its columns are taken, in metres; features narrower than this are not seen. */
    private static final double ASIDE = 1e-7;

    /** Corners within this many metres of an edge cut it. */
    private static final double ON_EDGE = 1e-8;

    private final World world;
    private final Columns columns;
    private final List<Polygon> outlines = new ArrayList<>();
    private final List<Ditch> ditches;
    private final List<Obstacle> obstacles;
    private double[] ends = new double[64];
    private int[] sides = new int[32];
    private int count;
    private double[] cuts = new double[16];

    /**
     * Cuts the outlines of the ditches and, if {@code obstacles}, of the immovable obstacles too; without them the
     * columns hold ground only.
     */
    Rims(Scene scene, Columns columns, boolean obstacles) {
        this.world = scene.world();
        this.columns = columns;
        this.ditches = scene.ditches();
        this.obstacles =
                obstacles ? scene.obstacles().stream().filter(o -> !o.movable()).toList() : List.of();
        ditches.forEach(d -> outlines.add(d.outline()));
        this.obstacles.forEach(o -> outlines.add(o.outline()));
        List<List<Integer>> meeting = meeting();
        for (int i = 0; i < outlines.size(); i++) {
            cut(outlines.get(i), meeting.get(i));
        }
    }

    /** Returns for each outline the ascending numbers of those whose box meets its own, itself included. */
    private List<List<Integer>> meeting() {
        List<List<Integer>> meeting = new ArrayList<>();
        for (int i = 0; i < outlines.size(); i++) {
            meeting.add(new ArrayList<>(List.of(i)));
        }
        Integer[] order = new Integer[outlines.size()];
        Arrays.setAll(order, i -> i);
        Arrays.sort(
                order, Comparator.comparingDouble(i -> outlines.get(i).bounds().minX()));
        for (int a = 0; a < order.length; a++) {
            Box box = outlines.get(order[a]).bounds().grown(2 * ASIDE);
            for (int b = a + 1; b < order.length; b++) {
                Box other = outlines.get(order[b]).bounds();
                if (other.minX() > box.maxX()) {
                    break;
                }
                if (box.meets(other)) {
                    meeting.get(order[a]).add(order[b]);
                    meeting.get(order[b]).add(order[a]);
                }
            }
        }
        meeting.forEach(list -> list.sort(null));
        return meeting;
    }

    private void cut(Polygon outline, List<Integer> meeting) {
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            double ax = outline.x(j);
            double ay = outline.y(j);
            double dx = outline.x(i) - ax;
            double dy = outline.y(i) - ay;
            double length = Math.sqrt(dx * dx + dy * dy);
            if (length <= ON_EDGE) {
                continue;
            }
            int n = cuts(ax, ay, dx, dy, length, outline, meeting);
            for (int k = 0; k + 1 < n; k++) {
                if ((cuts[k + 1] - cuts[k]) * length > ON_EDGE) {
                    keep(ax, ay, dx, dy, length, cuts[k], cuts[k + 1], meeting);
                }
            }
        }
    }

    /** Finds where an edge is cut, as ascending fractions of it from 0 to 1. */
    private int cuts(double ax, double ay, double dx, double dy, double length, Polygon own, List<Integer> meeting) {
        int n = 0;
        cuts[n++] = 0;
        cuts[n++] = 1;
        double slack = ON_EDGE / length;
        for (int number : meeting) {
            Polygon other = outlines.get(number);
            if (other == own) {
                continue;
            }
            for (int i = 0, j = other.size() - 1; i < other.size(); j = i++) {
                double before = ((other.x(j) - ax) * dy - (other.y(j) - ay) * dx) / length;
                double after = ((other.x(i) - ax) * dy - (other.y(i) - ay) * dx) / length;
                double t = Double.NaN;
                if (Math.abs(after) <= ON_EDGE) {
                    t = ((other.x(i) - ax) * dx + (other.y(i) - ay) * dy) / (length * length);
                } else if (before < 0 != after < 0 && Math.abs(before) > ON_EDGE) {
                    double s = before / (before - after);
                    double x = other.x(j) + s * (other.x(i) - other.x(j)) - ax;
                    double y = other.y(j) + s * (other.y(i) - other.y(j)) - ay;
                    t = (x * dx + y * dy) / (length * length);
                }
                n = cutAt(t, slack, n);
            }
        }
        n = cutAt(-ax / dx, slack, n);
        n = cutAt((world.width() - ax) / dx, slack, n);
        n = cutAt(-ay / dy, slack, n);
        n = cutAt((world.depth() - ay) / dy, slack, n);
        Arrays.sort(cuts, 0, n);
        return n;
    }

    private int cutAt(double t, double slack, int n) {
        if (!(t > slack && t < 1 - slack)) {
            return n;
        }
        if (n == cuts.length) {
            cuts = Arrays.copyOf(cuts, 2 * n);
        }
        cuts[n] = t;
        return n + 1;
    }

    private void keep(
            double ax, double ay, double dx, double dy, double length, double t0, double t1, List<Integer> meeting) {
        double x = ax + (t0 + t1) / 2 * dx;
        double y = ay + (t0 + t1) / 2 * dy;
        double nx = -dy / length * ASIDE;
        double ny = dx / length * ASIDE;
        int left = columnAt(x + nx, y + ny, meeting);
        int right = columnAt(x - nx, y - ny, meeting);
        if (left == right) {
            return;
        }
        if (2 * count == sides.length) {
            sides = Arrays.copyOf(sides, 2 * sides.length);
            ends = Arrays.copyOf(ends, 2 * ends.length);
        }
        ends[4 * count] = ax + t0 * dx;
        ends[4 * count + 1] = ay + t0 * dy;
        ends[4 * count + 2] = ax + t1 * dx;
        ends[4 * count + 3] = ay + t1 * dy;
        sides[2 * count] = left;
        sides[2 * count + 1] = right;
        count++;
    }

    private int columnAt(double x, double y, List<Integer> among) {
        if (x < 0 || y < 0 || x > world.width() || y > world.depth()) {
            return Columns.ROCK;
        }
        int id = columns.flat();
        for (int number : among) {
            if (outlines.get(number).contains(x, y)) {
                id = number < ditches.size()
                        ? columns.dug(id, ditches.get(number))
                        : columns.raised(id, obstacles.get(number - ditches.size()));
            }
        }
        return id;
    }

    /** Returns the number of pieces. */
    int size() {
        return count;
    }

    /** Returns the number of the column on the left of piece {@code i}. */
    int left(int i) {
        return sides[2 * i];
    }

    /** Returns the number of the column on the right of piece {@code i}. */
    int right(int i) {
        return sides[2 * i + 1];
    }

    /** Returns the squared distance in metres from a point to piece {@code i}. */
    double distanceSquared(int i, double x, double y) {
        return Segments.distanceSquared(x, y, ends[4 * i], ends[4 * i + 1], ends[4 * i + 2], ends[4 * i + 3]);
    }

    /** Adds the cells nearer than {@code radius} metres to piece {@code i}. */
    void near(int i, double radius, CellRuns runs) {
        runs.near(ends[4 * i], ends[4 * i + 1], ends[4 * i + 2], ends[4 * i + 3], radius);
    }

    /** Adds the cells whose open inside piece {@code i} crosses. */
    void touch(int i, CellRuns runs) {
        runs.touch(ends[4 * i], ends[4 * i + 1], ends[4 * i + 2], ends[4 * i + 3]);
    }
}
