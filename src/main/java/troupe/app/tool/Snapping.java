package troupe.app.tool;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import troupe.app.document.SceneEdits;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.scene.Scene;

/**
 * Draws places to what is near: corners of other things first, then their edges, then directions in
 * multiples of 45 degrees while Shift is held, then the grid; with Alt to nothing. The outline of the world
 * counts as a thing. Pure; an answer costs O(corners of the scene).
 */
public final class Snapping {
    /** How near in pixels a place must be to a corner or an edge. */
    static final double REACH = 8;

    /** The least distance in pixels between lines of the grid. */
    private static final double LEAST = 4;

    private static final double[] STEPS = {0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10};
    private static final double EIGHTH = Math.PI / 4;

    private final List<Polygon> targets = new ArrayList<>();
    private final double reach;
    private final double step;

    /**
     * Makes the snapping in a scene.
     *
     * @param leaveOut the ids of what does not attract, since it is what is moved
     * @param scale pixels per metre
     */
    public Snapping(Scene scene, Collection<String> leaveOut, double scale) {
        scene.elements().filter(e -> !leaveOut.contains(e.id())).forEach(e -> Hits.outline(e)
                .ifPresent(targets::add));
        targets.add(Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth()));
        reach = REACH / scale;
        step = step(scale);
    }

    /** Returns the distance between lines of the grid in metres, at so many pixels per metre. */
    public static double step(double scale) {
        for (double step : STEPS) {
            if (step * scale >= LEAST) {
                return step;
            }
        }
        return STEPS[STEPS.length - 1];
    }

    /** Returns where a place comes to lie; {@code anchor} is where directions begin, if there is such a place. */
    public Snap place(Point at, Optional<Point> anchor, boolean shift, boolean alt) {
        if (alt) {
            return new Snap(rounded(at), Optional.empty());
        }
        Optional<Snap> near = corner(at).or(() -> edge(at));
        if (near.isPresent()) {
            return near.get();
        }
        if (shift && anchor.isPresent()) {
            Point by =
                    direction(at.x() - anchor.get().x(), at.y() - anchor.get().y());
            Point to = rounded(new Point(anchor.get().x() + by.x(), anchor.get().y() + by.y()));
            return Snap.to(to, Guide.Kind.ANGLE, anchor.get(), to);
        }
        return onGrid(at);
    }

    /** Returns the nearest crossing of lines of the grid. */
    public Snap onGrid(Point at) {
        Point to = rounded(new Point(Math.rint(at.x() / step) * step, Math.rint(at.y() / step) * step));
        return Snap.to(to, Guide.Kind.GRID, to, to);
    }

    /** Returns how far to move things whose corners are these, where the pointer wants {@code by}. */
    public Snap move(List<Point> corners, Point by, boolean shift, boolean alt) {
        if (alt || corners.isEmpty()) {
            return new Snap(rounded(by), Optional.empty());
        }
        Optional<Snap> best = Optional.empty();
        for (Guide.Kind kind : List.of(Guide.Kind.CORNER, Guide.Kind.EDGE)) {
            double least = Double.POSITIVE_INFINITY;
            for (Point corner : corners) {
                Point there = new Point(corner.x() + by.x(), corner.y() + by.y());
                Optional<Snap> near = kind == Guide.Kind.CORNER ? corner(there) : edge(there);
                if (near.isPresent() && near.get().at().distance(there) < least) {
                    least = near.get().at().distance(there);
                    Point to = near.get().at();
                    best = Optional.of(new Snap(
                            new Point(to.x() - corner.x(), to.y() - corner.y()),
                            near.get().guide()));
                }
            }
            if (best.isPresent()) {
                return best.get();
            }
        }
        Point first = corners.get(0);
        if (shift) {
            Point along = direction(by.x(), by.y());
            return Snap.to(along, Guide.Kind.ANGLE, first, new Point(first.x() + along.x(), first.y() + along.y()));
        }
        Snap grid = onGrid(new Point(first.x() + by.x(), first.y() + by.y()));
        return new Snap(new Point(grid.at().x() - first.x(), grid.at().y() - first.y()), grid.guide());
    }

    private Optional<Snap> corner(Point at) {
        double least = reach;
        Point nearest = null;
        for (Polygon target : targets) {
            if (!target.bounds().grown(reach).contains(at.x(), at.y())) {
                continue;
            }
            for (int i = 0; i < target.size(); i++) {
                double away = Math.hypot(target.x(i) - at.x(), target.y(i) - at.y());
                if (away <= least) {
                    least = away;
                    nearest = new Point(target.x(i), target.y(i));
                }
            }
        }
        Point found = nearest;
        return Optional.ofNullable(found).map(p -> Snap.to(p, Guide.Kind.CORNER, p, p));
    }

    private Optional<Snap> edge(Point at) {
        double least = reach;
        Snap nearest = null;
        for (Polygon target : targets) {
            if (!target.bounds().grown(reach).contains(at.x(), at.y())) {
                continue;
            }
            for (int i = 0; i < target.size(); i++) {
                int j = (i + 1) % target.size();
                Point on = Segments.nearest(at.x(), at.y(), target.x(i), target.y(i), target.x(j), target.y(j));
                double away = on.distance(at);
                if (away <= least) {
                    least = away;
                    nearest = Snap.to(
                            rounded(on),
                            Guide.Kind.EDGE,
                            new Point(target.x(i), target.y(i)),
                            new Point(target.x(j), target.y(j)));
                }
            }
        }
        return Optional.ofNullable(nearest);
    }

    /** Returns a displacement in the nearest multiple of 45 degrees, its length in steps of the grid. */
    private Point direction(double dx, double dy) {
        double angle = Math.rint(Math.atan2(dy, dx) / EIGHTH) * EIGHTH;
        boolean slanted = Math.abs(Math.sin(2 * angle)) > 0.5;
        double along = dx * Math.cos(angle) + dy * Math.sin(angle);
        double leg = Math.rint(along * (slanted ? Math.sqrt(0.5) : 1) / step) * step;
        return new Point(
                leg * Math.signum(Math.rint(Math.cos(angle) * 10)), leg * Math.signum(Math.rint(Math.sin(angle) * 10)));
    }

    private static Point rounded(Point at) {
        return new Point(SceneEdits.rounded(at.x()), SceneEdits.rounded(at.y()));
    }
}
