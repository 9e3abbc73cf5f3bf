package troupe.app.tool;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Viewport;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Finds what lies under the pointer, nearest to the eye first. Pure. */
public final class Hits {
    /** How near in pixels the pointer must be to a thing without width. */
    public static final double REACH = 9;

    private static final double EDGE = 3;

    private Hits() {}

    /** An end of a journey. */
    public enum End {
        START,
        GOAL
    }

    /** Finds the end of a journey at a pixel, the goal before the start. */
    public static Optional<End> end(Journey journey, Viewport view, double px, double py) {
        if (near(journey.goal(), view, px, py)) {
            return Optional.of(End.GOAL);
        }
        return near(journey.start(), view, px, py) ? Optional.of(End.START) : Optional.empty();
    }

    private static boolean near(Place place, Viewport view, double px, double py) {
        double dx = view.px(place.x()) - px;
        double dy = view.py(place.y()) - py;
        return dx * dx + dy * dy <= REACH * REACH;
    }

    /** Finds the obstacle with the highest top, or else the ditch, at a place; {@code pixel} is the size of one in metres. */
    public static Optional<Element> element(Scene scene, Point at, double pixel) {
        List<Obstacle> obstacles = new ArrayList<>(scene.obstacles());
        obstacles.sort(Comparator.comparingDouble(Obstacle::top).reversed());
        for (Obstacle obstacle : obstacles) {
            if (covers(obstacle.outline(), at, pixel)) {
                return Optional.of(obstacle);
            }
        }
        for (Ditch ditch : scene.ditches()) {
            if (covers(ditch.outline(), at, pixel)) {
                return Optional.of(ditch);
            }
        }
        return Optional.empty();
    }

    private static boolean covers(Polygon outline, Point at, double pixel) {
        double edge = EDGE * pixel;
        return outline.bounds().grown(edge).contains(at.x(), at.y()) && outline.distance(at.x(), at.y()) <= edge;
    }

    /** Finds the obstacles and ditches that lie wholly in a box, in document order. */
    public static List<String> inside(Scene scene, Box box) {
        List<String> ids = new ArrayList<>();
        scene.elements().forEach(element -> outline(element).ifPresent(polygon -> {
            Box bounds = polygon.bounds();
            if (box.contains(bounds.minX(), bounds.minY()) && box.contains(bounds.maxX(), bounds.maxY())) {
                ids.add(element.id());
            }
        }));
        return ids;
    }

    /** Returns the outline of an obstacle or a ditch, empty for another element. */
    public static Optional<Polygon> outline(Element element) {
        if (element instanceof Obstacle obstacle) {
            return Optional.of(obstacle.outline());
        }
        return element instanceof Ditch ditch ? Optional.of(ditch.outline()) : Optional.empty();
    }
}
