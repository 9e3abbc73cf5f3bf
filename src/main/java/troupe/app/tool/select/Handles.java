package troupe.app.tool.select;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.document.SceneEdits;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.paint.Viewport;
import troupe.scene.Scene;

/**
 * Says what the pointer can take hold of on a selection: the corners of a single outline, a frame's corners to
 * scale, a knob above it to turn. Pure.
 *
 * @param corners the outline whose corners can be dragged, if there is one
 * @param box the bounds of everything selected, in metres
 */
record Handles(Optional<Polygon> corners, Box box) {
    /** How far the frame stands off what is selected, in pixels. */
    static final double OFF = 15;

    /** How far the knob stands above the frame, in pixels. */
    static final double KNOB = 20;

    private static final double REACH = 7;
    private static final double LEAST = 26;
    private static final int MOST_CORNERS = 60;

    /** What a handle does. */
    enum Kind {
        CORNER,
        SCALE,
        TURN
    }

    /** One handle: of the corners the one with this index, of the frame counter-clockwise from the lower left. */
    record Hold(Kind kind, int index) {}

    /** Finds the handles of a selection; none where nothing is selected that has an outline, or all is too small. */
    static Optional<Handles> of(Scene scene, List<String> ids, Viewport view) {
        List<Polygon> outlines = new ArrayList<>();
        ids.forEach(id -> SceneEdits.outline(scene, id).ifPresent(outlines::add));
        if (outlines.isEmpty()) {
            return Optional.empty();
        }
        Box box = outlines.get(0).bounds();
        for (Polygon outline : outlines) {
            Box b = outline.bounds();
            box = new Box(
                    Math.min(box.minX(), b.minX()),
                    Math.min(box.minY(), b.minY()),
                    Math.max(box.maxX(), b.maxX()),
                    Math.max(box.maxY(), b.maxY()));
        }
        boolean large = Math.max(box.width(), box.depth()) * view.scale() >= LEAST;
        boolean one = outlines.size() == 1 && outlines.get(0).size() <= MOST_CORNERS && large;
        return Optional.of(new Handles(one ? Optional.of(outlines.get(0)) : Optional.empty(), box));
    }

    /** Returns corner {@code i} of the box, counter-clockwise from the lower left. */
    Point boxCorner(int i) {
        return new Point(i == 0 || i == 3 ? box.minX() : box.maxX(), i < 2 ? box.minY() : box.maxY());
    }

    /** Returns the pixel of corner {@code i} of the frame. */
    double[] frameCorner(int i, Viewport view) {
        Point at = boxCorner(i);
        double right = i == 0 || i == 3 ? -OFF : OFF;
        return new double[] {view.px(at.x()) + right, view.py(at.y()) + (i < 2 ? OFF : -OFF)};
    }

    /** Returns the pixel of the knob. */
    double[] knob(Viewport view) {
        return new double[] {view.px((box.minX() + box.maxX()) / 2), view.py(box.maxY()) - OFF - KNOB};
    }

    /** Finds the handle at a pixel, corners first. */
    Optional<Hold> find(Viewport view, double px, double py) {
        if (corners.isPresent()) {
            Polygon outline = corners.get();
            for (int i = 0; i < outline.size(); i++) {
                if (near(view.px(outline.x(i)), view.py(outline.y(i)), px, py)) {
                    return Optional.of(new Hold(Kind.CORNER, i));
                }
            }
        }
        double[] knob = knob(view);
        if (near(knob[0], knob[1], px, py)) {
            return Optional.of(new Hold(Kind.TURN, 0));
        }
        for (int i = 0; i < 4; i++) {
            double[] corner = frameCorner(i, view);
            if (near(corner[0], corner[1], px, py)) {
                return Optional.of(new Hold(Kind.SCALE, i));
            }
        }
        return Optional.empty();
    }

    private static boolean near(double x, double y, double px, double py) {
        return Math.abs(x - px) <= REACH && Math.abs(y - py) <= REACH;
    }

    /** Finds the edge of the outline at a place, by the number of its first corner. */
    Optional<Integer> edge(Point at, double pixel) {
        if (corners.isEmpty()) {
            return Optional.empty();
        }
        Polygon outline = corners.get();
        int best = -1;
        double least = REACH * pixel;
        for (int i = 0; i < outline.size(); i++) {
            int j = (i + 1) % outline.size();
            double away = Math.sqrt(
                    Segments.distanceSquared(at.x(), at.y(), outline.x(i), outline.y(i), outline.x(j), outline.y(j)));
            if (away < least) {
                least = away;
                best = i;
            }
        }
        return best < 0 ? Optional.empty() : Optional.of(best);
    }
}
