package troupe.grid.region;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.grid.region.ground.Solid;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Answers for one place at a time what a region must hold there, straight from the definitions and as
 * slowly as they read: point in polygon, distance to every polygon, sampled discs, kernels cell by cell.
 */
final class SlowRegion {
    private static final double SAME = 1e-9;
    private static final int SAMPLES = 60;

    private final Scene scene;
    private final Actor actor;

    SlowRegion(Scene scene, Actor actor) {
        this.scene = scene;
        this.actor = actor;
    }

    /** A free stretch of a column. */
    record Stretch(double floor, double ceiling) {}

    private record Solid(double bottom, double top) {}

    boolean outside(double x, double y) {
        return !(x >= 0
                && y >= 0
                && x < scene.world().width()
                && y < scene.world().depth());
    }

    double ground(double x, double y) {
        double ground = 0;
        for (Ditch ditch : scene.ditches()) {
            if (ditch.outline().contains(x, y)) {
                ground = Math.min(ground, -ditch.depth());
            }
        }
        return ground;
    }

    /** Returns the merged solids over a point, from below; movable obstacles are none. */
    private List<Solid> solids(double x, double y) {
        List<Solid> all = new ArrayList<>();
        all.add(new Solid(-1e9, ground(x, y)));
        for (Obstacle o : scene.obstacles()) {
            if (!o.movable() && o.outline().contains(x, y)) {
                all.add(new Solid(o.offset(), o.top()));
            }
        }
        all.sort(Comparator.comparingDouble(Solid::bottom).thenComparingDouble(Solid::top));
        List<Solid> merged = new ArrayList<>();
        for (Solid s : all) {
            Solid last = merged.isEmpty() ? null : merged.get(merged.size() - 1);
            if (last == null || s.bottom() >= last.top() + 1e-3) {
                merged.add(s);
                continue;
            }
            merged.set(merged.size() - 1, new Solid(last.bottom(), Math.max(s.top(), last.top())));
        }
        return merged;
    }

    /** Returns the spans over a point, from below. */
    List<Stretch> spans(double x, double y) {
        double body = actor.vault()
                .map(v -> Math.min(v.bodyHeight(), actor.bodyHeight()))
                .orElse(actor.bodyHeight());
        List<Stretch> spans = new ArrayList<>();
        if (outside(x, y)) {
            return spans;
        }
        List<Solid> solids = solids(x, y);
        for (int i = 0; i < solids.size(); i++) {
            double ceiling = i + 1 < solids.size() ? solids.get(i + 1).bottom() : Double.POSITIVE_INFINITY;
            if (ceiling - solids.get(i).top() >= body - SAME) {
                spans.add(new Stretch(solids.get(i).top(), ceiling));
            }
        }
        return spans;
    }

    boolean meets(double bottom, double top, double low, double high) {
        return bottom < high - SAME && top > low + SAME;
    }

    boolean blocks(Obstacle o, double floor) {
        double low = o.movable() ? floor : floor + actor.stepHeight();
        return meets(o.offset(), o.top(), low, floor + actor.bodyHeight());
    }

    /** Returns the distance from a point to the world's edge and to the obstacles in a body's way; ground left out. */
    double clearanceOfObstacles(double x, double y, double floor) {
        double least = clearanceOfWorld(x, y);
        for (Obstacle o : scene.obstacles()) {
            if (blocks(o, floor)) {
                least = Math.min(least, o.outline().distance(x, y));
            }
        }
        return least;
    }

    private double clearanceOfWorld(double x, double y) {
        return Math.min(
                Math.min(x, scene.world().width() - x),
                Math.min(y, scene.world().depth() - y));
    }

    /** Tells whether a sampled point nearer than {@code radius} has ground in the way of a body on {@code floor}. */
    boolean groundWithin(double x, double y, double floor, double radius) {
        double limit = floor + actor.stepHeight() + SAME;
        if (scene.ditches().isEmpty()) {
            return 0 > limit;
        }
        return disc(x, y, radius, (px, py) -> ground(px, py) > limit);
    }

    /** Tells whether a sampled point nearer than {@code radius} lies in the world and has that very ground. */
    boolean groundAt(double x, double y, double elevation, double radius) {
        return disc(x, y, radius, (px, py) -> !outside(px, py) && ground(px, py) == elevation);
    }

    /** Tells whether the outline of an obstacle or ditch wall in a body's way, or the world's, crosses a cell's inside. */
    boolean touched(double x, double y, double half, double floor) {
        Polygon world =
                Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth());
        if (crosses(world, x, y, half)) {
            return true;
        }
        for (Obstacle o : scene.obstacles()) {
            if (blocks(o, floor) && crosses(o.outline(), x, y, half)) {
                return true;
            }
        }
        return false;
    }

    /** Tells whether an outline crosses the open square of half side {@code half}, by clipping each edge to it. */
    static boolean crosses(Polygon p, double x, double y, double half) {
        for (int i = 0, j = p.size() - 1; i < p.size(); j = i++) {
            double t0 = 0;
            double t1 = 1;
            double[] from = {p.x(j) - x, p.y(j) - y};
            double[] by = {p.x(i) - p.x(j), p.y(i) - p.y(j)};
            for (int axis = 0; axis < 2; axis++) {
                if (Math.abs(by[axis]) < 1e-12) {
                    if (Math.abs(from[axis]) >= half - SAME) {
                        t1 = -1;
                    }
                    continue;
                }
                double a = (-half - from[axis]) / by[axis];
                double b = (half - from[axis]) / by[axis];
                t0 = Math.max(t0, Math.min(a, b));
                t1 = Math.min(t1, Math.max(a, b));
            }
            if (t1 - t0 > 1e-9) {
                return true;
            }
        }
        return false;
    }

    /** Says something of a point. */
    interface Test {
        boolean holds(double x, double y);
    }

    /**
     * Tries the centre of a disc and, closely spaced, both sides of every outline within it: whatever
     * changes in the disc changes across an outline.
     */
    private boolean disc(double x, double y, double radius, Test test) {
        if (test.holds(x, y)) {
            return true;
        }
        List<Polygon> outlines = new ArrayList<>();
        outlines.add(
                Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth()));
        scene.ditches().forEach(d -> outlines.add(d.outline()));
        scene.obstacles().forEach(o -> outlines.add(o.outline()));
        for (Polygon p : outlines) {
            for (int i = 0, j = p.size() - 1; i < p.size(); j = i++) {
                if (edge(x, y, radius, test, p.x(j), p.y(j), p.x(i) - p.x(j), p.y(i) - p.y(j))) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean edge(
            double x, double y, double radius, Test test, double ax, double ay, double dx, double dy) {
        double length = Math.hypot(dx, dy);
        double along = ((x - ax) * dx + (y - ay) * dy) / length;
        double aside = ((x - ax) * dy - (y - ay) * dx) / length;
        if (Math.abs(aside) >= radius) {
            return false;
        }
        double half = Math.sqrt(radius * radius - aside * aside);
        double from = Math.max(0, along - half);
        double to = Math.min(length, along + half);
        for (int k = 0; k < SAMPLES && to > from; k++) {
            double t = (from + (to - from) * (k + 0.5) / SAMPLES) / length;
            double px = ax + t * dx;
            double py = ay + t * dy;
            double nx = -dy / length * 1e-6;
            double ny = dx / length * 1e-6;
            if (test.holds(px + nx, py + ny) || test.holds(px - nx, py - ny)) {
                return true;
            }
        }
        return false;
    }

    /** Returns the floor at a point for a foot on {@code floor}; NaN where a solid stands in the body's way. */
    private double under(double x, double y, double floor) {
        if (outside(x, y)) {
            return Double.NaN;
        }
        double highest = Double.NEGATIVE_INFINITY;
        for (Solid s : solids(x, y)) {
            if (meets(s.bottom(), s.top(), floor + actor.stepHeight(), floor + actor.bodyHeight())) {
                return Double.NaN;
            }
            if (s.top() <= floor + actor.stepHeight() + SAME) {
                highest = s.top();
            }
        }
        return highest;
    }

    boolean overDrop(double x, double y, double floor, double radius) {
        return disc(x, y, radius, (px, py) -> under(px, py, floor) < floor - actor.stepHeight() - SAME);
    }

    boolean onEdge(double x, double y, double floor, double radius) {
        return disc(x, y, radius, (px, py) -> Math.abs(under(px, py, floor) - floor) > SAME);
    }
}
