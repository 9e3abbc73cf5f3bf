package troupe.work.inspect;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.grid.DistanceTransform;
import troupe.grid.GridFrame;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Lays what stops a walking actor on one floor into a grid: obstacles that are neither stepped on nor passed
 * under, and ditches deeper than a step. A simpler picture than the region of the grid core, which knows stairs,
 * layers and abilities: good for saying what is in the way, not for planning. Cost O(cells + covered cells x
 * corners). Used by the thread that makes it.
 */
final class Obstruction {
    /** The most cells of a grid that is made. */
    static final int MOST_CELLS = 2_000_000;

    private final GridFrame frame;
    private final List<String> ids = new ArrayList<>();
    private final List<Polygon> outlines = new ArrayList<>();
    private final short[] solid;
    private final int[] squared;

    private Obstruction(Scene scene, Actor actor, double floor) {
        frame = GridFrame.of(scene.world());
        solid = new short[frame.size()];
        squared = new int[frame.size()];
        for (Obstacle o : scene.obstacles()) {
            if (o.offset() < floor + actor.bodyHeight() && o.top() > floor + actor.stepHeight()) {
                add(o.id(), o.outline());
            }
        }
        for (Ditch d : scene.ditches()) {
            if (d.depth() > actor.stepHeight() && floor <= actor.stepHeight()) {
                add(d.id(), d.outline());
            }
        }
        byte[] sources = new byte[frame.size()];
        for (int i = 0; i < sources.length; i++) {
            sources[i] = (byte) (solid[i] == 0 ? 0 : 1);
        }
        new DistanceTransform(frame.cols(), frame.rows()).compute(sources, squared);
    }

    /** Makes the grid for an actor on a floor at an elevation, in metres; empty where it would be too large. */
    static Optional<Obstruction> of(Scene scene, Actor actor, double floor) {
        long cells = (long) scene.world().cols() * scene.world().rows();
        boolean few = scene.obstacles().size() + scene.ditches().size() < Short.MAX_VALUE;
        return cells <= MOST_CELLS && few ? Optional.of(new Obstruction(scene, actor, floor)) : Optional.empty();
    }

    private void add(String id, Polygon outline) {
        ids.add(id);
        outlines.add(outline);
        Box box = outline.bounds();
        int col0 = Math.max(0, (int) Math.floor((box.minX() - frame.originX()) / frame.cell()));
        int row0 = Math.max(0, (int) Math.floor((box.minY() - frame.originY()) / frame.cell()));
        int col1 = Math.min(frame.cols() - 1, (int) Math.floor((box.maxX() - frame.originX()) / frame.cell()));
        int row1 = Math.min(frame.rows() - 1, (int) Math.floor((box.maxY() - frame.originY()) / frame.cell()));
        double half = frame.cell() / 2;
        for (int row = row0; row <= row1; row++) {
            for (int col = col0; col <= col1; col++) {
                if (outline.distance(frame.centreX(col), frame.centreY(row)) <= half) {
                    solid[frame.index(col, row)] = (short) ids.size();
                }
            }
        }
    }

    GridFrame frame() {
        return frame;
    }

    /** Returns the number of what fills a cell, from 0, or -1 where it is free. */
    int at(int cell) {
        return solid[cell] - 1;
    }

    String id(int number) {
        return ids.get(number);
    }

    /** Returns the diagonal of the box around a thing, in metres. */
    double diagonal(int number) {
        Box box = outlines.get(number).bounds();
        return Math.hypot(box.width(), box.depth());
    }

    /** Returns the distance in metres from a free cell to what fills another, or to the border of the world. */
    double clearance(int cell) {
        double border = Math.min(
                        Math.min(frame.col(cell), frame.cols() - 1 - frame.col(cell)),
                        Math.min(frame.row(cell), frame.rows() - 1 - frame.row(cell)))
                - 0.5;
        double near = squared[cell] == DistanceTransform.NONE ? border : Math.sqrt(squared[cell]);
        return Math.min(near, border) * frame.cell();
    }

    /** Returns the middle of a cell. */
    Point middle(int cell) {
        return new Point(frame.centreX(frame.col(cell)), frame.centreY(frame.row(cell)));
    }

    /** Finds the two things nearest to a place, the nearest first; fewer where there are not two. */
    List<Integer> nearest(Point place) {
        int first = -1;
        int second = -1;
        for (int i = 0; i < outlines.size(); i++) {
            double away = away(i, place);
            if (first < 0 || away < away(first, place)) {
                second = first;
                first = i;
            } else if (second < 0 || away < away(second, place)) {
                second = i;
            }
        }
        List<Integer> found = new ArrayList<>();
        if (first >= 0) {
            found.add(first);
        }
        if (second >= 0) {
            found.add(second);
        }
        return found;
    }

    private double away(int number, Point place) {
        return outlines.get(number).distance(place.x(), place.y());
    }

    /** Returns the distance from a place to a thing, in metres. */
    double distance(int number, Point place) {
        return away(number, place);
    }

    /** Finds the free place nearest to another with at least this clearance; ties go to the first cell. */
    Optional<Place> free(Place wanted, double radius) {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < frame.size(); i++) {
            if (at(i) < 0 && clearance(i) >= radius + frame.cell()) {
                Point middle = middle(i);
                double away = Math.hypot(middle.x() - wanted.x(), middle.y() - wanted.y());
                if (away < least) {
                    least = away;
                    best = i;
                }
            }
        }
        if (best < 0) {
            return Optional.empty();
        }
        Point middle = middle(best);
        return Optional.of(new Place(rounded(middle.x()), rounded(middle.y()), wanted.z()));
    }

    private static double rounded(double metres) {
        return Math.rint(metres * 1e3) / 1e3;
    }
}
