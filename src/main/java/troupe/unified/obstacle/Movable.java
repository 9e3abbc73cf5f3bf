package troupe.unified.obstacle;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.grid.layer.Column;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Knows the shape of one movable obstacle at every pose of its lattice: steps of a cell, and of a full turn
 * divided by the number of headings, about its area centroid. Shapes and stamps of a heading are worked out
 * when they are first asked for and then kept. Immutable as seen from outside; safe for any thread.
 */
public final class Movable {
    /** Distance in metres between two holds along the outline. */
    public static final double HOLD_SPACING = 0.3;

    private static final double SLACK = 1e-9;

    private final int number;
    private final Obstacle obstacle;
    private final double cell;
    private final int headings;
    private final Point centroid;
    private final double farthest;
    private final double inner;
    private final double[] cosines;
    private final double[] sines;
    private final AtomicReferenceArray<Polygon> outlines;
    private final AtomicReferenceArray<Polygon> insets;
    private final AtomicReferenceArray<Stamp[]> stamps;

    /**
     * Anchors the lattice at the obstacle's own pose.
     *
     * @param number the number of the obstacle among those of the scene
     * @param cell the size of a cell in metres
     * @param headings the number of headings, at least 1
     */
    public Movable(int number, Obstacle obstacle, double cell, int headings) {
        if (headings < 1) {
            throw new IllegalArgumentException("headings=" + headings + "; needs at least 1");
        }
        this.number = number;
        this.obstacle = obstacle;
        this.cell = cell;
        this.headings = headings;
        Polygon outline = obstacle.outline();
        this.centroid = outline.centroid();
        double most = 0;
        for (int i = 0; i < outline.size(); i++) {
            most = Math.max(most, centroid.distance(outline.x(i), outline.y(i)));
        }
        this.farthest = most;
        this.inner = outline.contains(centroid.x(), centroid.y())
                ? outline.distanceToOutline(centroid.x(), centroid.y())
                : 0;
        this.cosines = new double[headings];
        this.sines = new double[headings];
        for (int k = 0; k < headings; k++) {
            cosines[k] = StrictMath.cos(k * turn());
            sines[k] = StrictMath.sin(k * turn());
        }
        this.outlines = new AtomicReferenceArray<>(headings);
        this.insets = new AtomicReferenceArray<>(headings);
        this.stamps = new AtomicReferenceArray<>(headings);
    }

    /** Returns the movable obstacles of a scene in document order, whatever they stand on or carry. */
    public static List<Movable> of(Scene scene, int headings) {
        List<Movable> found = new ArrayList<>();
        for (int i = 0; i < scene.obstacles().size(); i++) {
            if (scene.obstacles().get(i).movable()) {
                found.add(new Movable(i, scene.obstacles().get(i), scene.world().cell(), headings));
            }
        }
        return List.copyOf(found);
    }

    /** Returns the number of the obstacle among those of the scene. */
    public int number() {
        return number;
    }

    /** Returns the obstacle as the scene shows it. */
    public Obstacle obstacle() {
        return obstacle;
    }

    /** Returns the step of the lattice in metres. */
    public double cell() {
        return cell;
    }

    /** Returns the number of headings. */
    public int headings() {
        return headings;
    }

    /** Returns the angle in radians between two headings that follow each other. */
    public double turn() {
        return 2 * Math.PI / headings;
    }

    /** Returns the cosine of heading {@code k}. */
    double cos(int k) {
        return cosines[k];
    }

    /** Returns the sine of heading {@code k}. */
    double sin(int k) {
        return sines[k];
    }

    /** Returns the area centroid in the pose that the scene shows, in metres. */
    public Point centroid() {
        return centroid;
    }

    /** Returns the distance in metres from the centroid to the farthest corner. */
    public double farthest() {
        return farthest;
    }

    /** Returns the radius in metres of the largest disc about the centroid in the obstacle, 0 if that lies outside of it. */
    public double innerRadius() {
        return inner;
    }

    /** Returns where a lattice pose puts the centroid in metres, and the heading in radians, in [0, 2π). */
    public Pose pose(LatticePose at) {
        return new Pose(centroid.x() + at.i() * cell, centroid.y() + at.j() * cell, at.k() * turn());
    }

    /** Returns the outline at a lattice pose; the scene's own at {@link LatticePose#HOME}. Cost O(corners). */
    public Polygon outline(LatticePose at) {
        Polygon turned = outline(at.k());
        return at.i() == 0 && at.j() == 0 ? turned : turned.shifted(at.i() * cell, at.j() * cell);
    }

    /** Returns the outline turned to heading {@code k}, {@code 0 <= k < headings()}, where it stands. */
    public Polygon outline(int k) {
        Polygon known = outlines.get(k);
        if (known == null) {
            known = k == 0
                    ? obstacle.outline()
                    : obstacle.outline().at(new Pose(centroid.x(), centroid.y(), k * turn()));
            outlines.set(k, known);
        }
        return known;
    }

    /** Returns the outline of heading {@code k} drawn in by the tolerance of motions, relative to the centroid. */
    Polygon inset(int k) {
        Polygon known = insets.get(k);
        if (known == null) {
            known = Inset.of(obstacle.outline(), SLACK).shifted(-centroid.x(), -centroid.y());
            if (k != 0) {
                known = turned(known, k);
            }
            insets.set(k, known);
        }
        return known;
    }

    private Polygon turned(Polygon relative, int k) {
        double cos = cosines[k];
        double sin = sines[k];
        double[] xs = new double[relative.size()];
        double[] ys = new double[relative.size()];
        for (int i = 0; i < xs.length; i++) {
            xs[i] = cos * relative.x(i) - sin * relative.y(i);
            ys[i] = sin * relative.x(i) + cos * relative.y(i);
        }
        return new Polygon(xs, ys);
    }

    /**
     * Returns the points of the outline, in the pose that the scene shows, at which it can be held: every
     * {@link #HOLD_SPACING} metres from corner 0 in the order of the corners.
     */
    public List<Point> holds() {
        Polygon outline = obstacle.outline();
        List<Point> holds = new ArrayList<>();
        double walked = 0;
        for (int i = 0; i < outline.size(); i++) {
            int next = (i + 1) % outline.size();
            double dx = outline.x(next) - outline.x(i);
            double dy = outline.y(next) - outline.y(i);
            double length = Math.sqrt(dx * dx + dy * dy);
            while (holds.size() * HOLD_SPACING < walked + length - SLACK) {
                double t = (holds.size() * HOLD_SPACING - walked) / length;
                holds.add(new Point(outline.x(i) + t * dx, outline.y(i) + t * dy));
            }
            walked += length;
        }
        return holds;
    }

    /**
     * Returns the cells of the world's frame whose centre is nearer than {@code radius}, by more than 1e-9 m,
     * to the obstacle turned to heading {@code k} where it stands. The cells may lie outside of the frame.
     */
    public Stamp stamp(int k, double radius) {
        Stamp[] known = stamps.get(k);
        if (known != null) {
            for (Stamp stamp : known) {
                if (stamp.radius() == radius) {
                    return stamp;
                }
            }
        }
        Stamp added = Stamp.of(outline(k), radius, cell);
        Stamp[] grown = known == null ? new Stamp[1] : Arrays.copyOf(known, known.length + 1);
        grown[grown.length - 1] = added;
        stamps.set(k, grown);
        return added;
    }

    /** Tells whether the obstacle fills a part of the stretch of a body of {@code bodyHeight} on a floor. */
    public boolean meets(double floor, double bodyHeight) {
        return obstacle.offset() < floor + bodyHeight - Column.SAME && obstacle.top() > floor + Column.SAME;
    }

    /**
     * Tells whether the obstacle at a lattice pose is nearer than {@code radius}, by more than 1e-9 m, to the
     * centre of a cell of the world's frame; being inside counts as distance 0. Cost O(1) once the heading
     * has its stamp.
     */
    public boolean isNear(int i, int j, int k, int col, int row, double radius) {
        return stamp(k, radius).contains(col - i, row - j);
    }
}
