package troupe.unified.obstacle;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Tells where a movable obstacle rests: its centroid, and at least three fifths of a sample of its
 * footprint, lie over support at the elevation of its underside. Support is the ground outside ditches, the
 * bottom of a ditch, and the tops of immovable obstacles. The sample is the points of a 16 x 16 grid over
 * the outline's box that lie inside it, carried along rigidly. Used by one thread at a time.
 */
public final class Support {
    private static final int SAMPLES = 16;
    private static final double SLACK = 1e-9;

    private final Movable movable;
    private final double elevation;
    private final boolean grounded;
    private final Ditch[] ditches;
    private final Polygon[] tops;
    private final double[] sampleX;
    private final double[] sampleY;

    /** Collects what can carry the obstacle in a scene. */
    Support(Scene scene, Movable movable) {
        this.movable = movable;
        this.elevation = movable.obstacle().offset();
        this.grounded = elevation <= SLACK;
        this.ditches = grounded ? scene.ditches().toArray(new Ditch[0]) : new Ditch[0];
        this.tops = scene.obstacles().stream()
                .filter(o -> !o.movable() && Math.abs(o.top() - elevation) <= SLACK)
                .map(Obstacle::outline)
                .toArray(Polygon[]::new);
        List<Point> samples = samples(movable);
        this.sampleX = samples.stream().mapToDouble(Point::x).toArray();
        this.sampleY = samples.stream().mapToDouble(Point::y).toArray();
    }

    private static List<Point> samples(Movable movable) {
        Polygon outline = movable.obstacle().outline();
        Box box = outline.bounds();
        List<Point> inside = new ArrayList<>();
        for (int row = 0; row < SAMPLES; row++) {
            double y = box.minY() + (row + 0.5) * box.depth() / SAMPLES;
            for (int col = 0; col < SAMPLES; col++) {
                double x = box.minX() + (col + 0.5) * box.width() / SAMPLES;
                if (outline.contains(x, y)) {
                    inside.add(new Point(
                            x - movable.centroid().x(), y - movable.centroid().y()));
                }
            }
        }
        return inside;
    }

    /** Tells whether the obstacle rests at a lattice pose. Cost O(ditches) on plain ground, O(samples) at its end. */
    public boolean rests(int i, int j, int k) {
        double x = movable.centroid().x() + i * movable.cell();
        double y = movable.centroid().y() + j * movable.cell();
        if (isWhole(x, y)) {
            return true;
        }
        if (!carries(x, y)) {
            return false;
        }
        double cos = movable.cos(k);
        double sin = movable.sin(k);
        int need = (6 * sampleX.length + 9) / 10;
        int spare = sampleX.length - need;
        for (int n = 0; n < sampleX.length && need > 0; n++) {
            if (carries(x + cos * sampleX[n] - sin * sampleY[n], y + sin * sampleX[n] + cos * sampleY[n])) {
                need--;
            } else if (--spare < 0) {
                return false;
            }
        }
        return true;
    }

    /** Tells whether everything within the farthest corner's distance of a point is surely support. */
    private boolean isWhole(double x, double y) {
        double r = movable.farthest();
        if (Math.abs(elevation) <= SLACK) {
            for (Ditch ditch : ditches) {
                Box box = ditch.outline().bounds();
                if (box.minX() <= x + r && box.maxX() >= x - r && box.minY() <= y + r && box.maxY() >= y - r) {
                    return false;
                }
            }
            return true;
        }
        for (Polygon top : tops) {
            if (top.contains(x, y) && top.distanceToOutline(x, y) > r) {
                return true;
            }
        }
        return false;
    }

    /** Tells whether there is support at a point. */
    private boolean carries(double x, double y) {
        if (grounded) {
            double ground = 0;
            for (Ditch ditch : ditches) {
                if (-ditch.depth() < ground && ditch.outline().contains(x, y)) {
                    ground = -ditch.depth();
                }
            }
            if (Math.abs(ground - elevation) <= SLACK) {
                return true;
            }
        }
        for (Polygon top : tops) {
            if (top.contains(x, y)) {
                return true;
            }
        }
        return false;
    }
}
