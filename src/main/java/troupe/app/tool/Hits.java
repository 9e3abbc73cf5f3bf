package troupe.app.tool;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import troupe.app.document.Mark;
import troupe.app.document.Parts;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Viewport;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;

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

    private static boolean near(Place place, Viewport view, double px, double py) {
        double dx = view.px(place.x()) - px;
        double dy = view.py(place.y()) - py;
        return dx * dx + dy * dy <= REACH * REACH;
    }

    /** Finds the place of a task at a pixel; of several the one that lies above the others, the last. */
    public static Optional<Mark> mark(Task task, Viewport view, double px, double py) {
        Mark found = null;
        for (Mark mark : Mark.of(task)) {
            found = near(mark.place(), view, px, py) ? mark : found;
        }
        return Optional.ofNullable(found);
    }

    /** Finds the group of a crowd whose members stand at a place at first, the last that does; by its id. */
    public static Optional<String> spawn(Scene scene, Task task, Point at, double pixel) {
        return Parts.of(task)
                .filter(id ->
                        Parts.spawn(scene, id).filter(o -> covers(o, at, pixel)).isPresent())
                .reduce((first, last) -> last);
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
            if (isIn(box, polygon)) {
                ids.add(element.id());
            }
        }));
        return ids;
    }

    /**
     * Finds what of a task lies in a box: avatars that start there, groups that stand there wholly at first, and single
     * places ({@link Mark}); the task itself in place of its ends if both are there.
     */
    public static List<String> inside(Scene scene, Task task, Box box) {
        List<String> ids = new ArrayList<>();
        Parts.of(task)
                .filter(id -> Parts.spawn(scene, id).filter(o -> isIn(box, o)).isPresent())
                .forEach(ids::add);
        List<Mark> marks = Mark.of(task).stream()
                .filter(m -> box.contains(m.place().x(), m.place().y()))
                .toList();
        long ends = marks.stream().filter(m -> m.owner().equals(task.id())).count();
        marks.stream()
                .map(m -> ends > 1 && m.owner().equals(task.id()) ? task.id() : m.id())
                .distinct()
                .forEach(ids::add);
        return ids;
    }

    private static boolean isIn(Box box, Polygon outline) {
        Box bounds = outline.bounds();
        return box.contains(bounds.minX(), bounds.minY()) && box.contains(bounds.maxX(), bounds.maxY());
    }

    /** Returns the outline of an obstacle or a ditch, empty for another element. */
    public static Optional<Polygon> outline(Element element) {
        if (element instanceof Obstacle obstacle) {
            return Optional.of(obstacle.outline());
        }
        return element instanceof Ditch ditch ? Optional.of(ditch.outline()) : Optional.empty();
    }
}
