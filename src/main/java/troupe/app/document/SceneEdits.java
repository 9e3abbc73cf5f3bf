package troupe.app.document;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BinaryOperator;
import java.util.function.UnaryOperator;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.scene.CrowdGroup;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.Task;

/** Makes changed scenes out of scenes: what the tools and the inspector do. Pure; safe on any thread. */
public final class SceneEdits {
    private SceneEdits() {}

    /**
     * Returns the scene with what these ids name shifted by {@code (dx, dy)} metres: obstacles, ditches, where an avatar
     * or the members of a group stand at first, both ends of a task, single places ({@link Mark}).
     */
    public static Scene shifted(Scene scene, Collection<String> ids, double dx, double dy) {
        Scene changed = scene;
        for (String id : ids) {
            Element element = scene.element(id).orElse(null);
            if (element instanceof Obstacle obstacle) {
                changed = changed.with(obstacle.withOutline(obstacle.outline().shifted(dx, dy)));
            } else if (element instanceof Ditch ditch) {
                changed = changed.with(ditch.withOutline(ditch.outline().shifted(dx, dy)));
            } else if (element instanceof Task task) {
                changed = shiftedEnds(changed, task, dx, dy);
            } else {
                Scene now = changed;
                changed = Mark.find(now, id)
                        .filter(mark -> scene.task(mark.owner()).isEmpty() || !ids.contains(mark.owner()))
                        .map(mark -> mark.moved(now, shifted(mark.place(), dx, dy)))
                        .orElseGet(() -> shiftedPart(now, id, dx, dy));
            }
        }
        return changed;
    }

    private static Place shifted(Place place, double dx, double dy) {
        return new Place(rounded(place.x() + dx), rounded(place.y() + dy), place.z());
    }

    private static Scene shiftedEnds(Scene scene, Task task, double dx, double dy) {
        return between(scene, task.id(), (start, goal) -> shifted(start, dx, dy), (s, goal) -> shifted(goal, dx, dy));
    }

    /** Shifts where the members of a group stand at first, or where an avatar starts. */
    private static Scene shiftedPart(Scene scene, String id, double dx, double dy) {
        Scene changed = Parts.withMembers(
                scene,
                id,
                m -> new CrowdGroup.Members(
                        m.count(), rounded(m.spawn().shifted(dx, dy)), m.floor(), m.radius(), m.speed()));
        return Parts.withAvatar(changed, id, avatar -> Mark.start(avatar)
                .map(p -> Mark.starting(avatar, shifted(p, dx, dy)))
                .orElse(avatar));
    }

    /** Returns the outline of an obstacle, a ditch or a group's first place; empty for anything else. */
    public static Optional<Polygon> outline(Scene scene, String id) {
        Element element = scene.element(id).orElse(null);
        if (element instanceof Obstacle obstacle) {
            return Optional.of(obstacle.outline());
        }
        return element instanceof Ditch ditch ? Optional.of(ditch.outline()) : Parts.spawn(scene, id);
    }

    /** Returns the outline with its area centroid at {@code centre}, rounded to a tenth of a millimetre. */
    public static Polygon centred(Polygon outline, Point centre) {
        Point from = outline.centroid();
        return rounded(outline.shifted(centre.x() - from.x(), centre.y() - from.y()));
    }

    /** Returns the outline turned about its area centroid, counter-clockwise, rounded to a tenth of a millimetre. */
    public static Polygon turned(Polygon outline, double rad) {
        Point centre = outline.centroid();
        return rounded(outline.at(new Pose(centre.x(), centre.y(), rad)));
    }

    /** Returns the outline with each corner rounded to a tenth of a millimetre, so that files stay readable. */
    public static Polygon rounded(Polygon outline) {
        double[] xs = new double[outline.size()];
        double[] ys = new double[outline.size()];
        for (int i = 0; i < xs.length; i++) {
            xs[i] = rounded(outline.x(i));
            ys[i] = rounded(outline.y(i));
        }
        return new Polygon(xs, ys);
    }

    /** Returns an obstacle or a ditch with rounded corners; another element as it is. */
    public static Element tidied(Element element) {
        if (element instanceof Obstacle obstacle) {
            return obstacle.withOutline(rounded(obstacle.outline()));
        }
        return element instanceof Ditch ditch ? ditch.withOutline(rounded(ditch.outline())) : element;
    }

    /** Returns an obstacle or a ditch with another outline; another element as it is. */
    public static Element reshaped(Element element, Polygon outline) {
        if (element instanceof Obstacle obstacle) {
            return obstacle.withOutline(outline);
        }
        return element instanceof Ditch ditch ? ditch.withOutline(outline) : element;
    }

    /** Returns the scene with the outlines of these elements changed; other elements stay. */
    public static Scene reshaped(Scene scene, Collection<String> ids, UnaryOperator<Polygon> change) {
        Scene changed = scene;
        for (String id : ids) {
            Element element = scene.element(id).orElse(null);
            if (element instanceof Obstacle obstacle) {
                changed = changed.with(obstacle.withOutline(change.apply(obstacle.outline())));
            } else if (element instanceof Ditch ditch) {
                changed = changed.with(ditch.withOutline(change.apply(ditch.outline())));
            } else {
                changed = Parts.withMembers(
                        changed,
                        id,
                        m -> new CrowdGroup.Members(
                                m.count(), change.apply(m.spawn()), m.floor(), m.radius(), m.speed()));
            }
        }
        return changed;
    }

    /** Returns the name to show of an element or a part of a task, its id if the scene does not hold it. */
    public static String name(Scene scene, String id) {
        return scene.element(id)
                .map(Element::name)
                .or(() -> Parts.name(scene, id))
                .or(() -> Mark.find(scene, id).map(mark -> name(scene, mark.owner())))
                .orElse(id);
    }

    /** Returns a length in metres rounded to a tenth of a millimetre. */
    public static double rounded(double metres) {
        return Math.rint(metres * 1e4) / 1e4;
    }

    /** Returns the scene without the elements, and the parts of tasks, of these ids. */
    public static Scene removed(Scene whole, Collection<String> ids) {
        Scene without = whole;
        // from the last goal of an avatar to the first: the numbers of those behind it change
        for (Mark mark : ids.stream()
                .flatMap(id -> Mark.find(whole, id).stream())
                .sorted(Comparator.comparingInt(Mark::number).reversed())
                .toList()) {
            without = mark.removed(without);
        }
        Scene scene = Parts.removed(
                without,
                ids.stream()
                        .filter(id -> !ids.contains(id.replaceAll("/.*", "")))
                        .toList());
        return new Scene(
                scene.title(),
                scene.world(),
                kept(scene.obstacles(), ids),
                kept(scene.ditches(), ids),
                kept(scene.actors(), ids),
                kept(scene.tasks(), ids));
    }

    private static <E extends Element> List<E> kept(List<E> all, Collection<String> ids) {
        return all.stream().filter(e -> !ids.contains(e.id())).toList();
    }

    /** Returns the scene with the journey beginning elsewhere. */
    public static Scene startingAt(Scene scene, Journey journey, Place place) {
        return startingAt(scene, journey.id(), place);
    }

    /** Returns the scene with the journey ending elsewhere. */
    public static Scene endingAt(Scene scene, Journey journey, Place place) {
        return endingAt(scene, journey.id(), place);
    }

    /** Returns the scene with a journey or an encounter beginning elsewhere; another task stays. */
    public static Scene startingAt(Scene scene, String task, Place place) {
        return between(scene, task, (start, goal) -> place, (start, goal) -> goal);
    }

    /** Returns the scene with a journey or an encounter ending elsewhere; another task stays. */
    public static Scene endingAt(Scene scene, String task, Place place) {
        return between(scene, task, (start, goal) -> start, (start, goal) -> place);
    }

    private static Scene between(Scene scene, String id, BinaryOperator<Place> start, BinaryOperator<Place> goal) {
        Task task = scene.task(id).orElse(null);
        if (task instanceof Journey j) {
            return scene.with(j.between(start.apply(j.start(), j.goal()), goal.apply(j.start(), j.goal())));
        }
        return task instanceof Encounter e
                ? scene.with(e.between(start.apply(e.start(), e.goal()), goal.apply(e.start(), e.goal())))
                : scene;
    }

    /** Returns the scene with other preferences for the journey. */
    public static Scene preferring(Scene scene, Journey journey, Preferences preferences) {
        return scene.with(journey.preferring(preferences));
    }
}
