package troupe.app.document;

import java.util.Collection;
import java.util.List;
import java.util.function.UnaryOperator;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;

/** Makes changed scenes out of scenes: what the tools and the inspector do. Pure; safe on any thread. */
public final class SceneEdits {
    private SceneEdits() {}

    /** Returns the scene with the obstacles and ditches of these ids shifted by {@code (dx, dy)} metres. */
    public static Scene shifted(Scene scene, Collection<String> ids, double dx, double dy) {
        Scene changed = scene;
        for (String id : ids) {
            Element element = scene.element(id).orElse(null);
            if (element instanceof Obstacle obstacle) {
                changed = changed.with(obstacle.withOutline(obstacle.outline().shifted(dx, dy)));
            } else if (element instanceof Ditch ditch) {
                changed = changed.with(ditch.withOutline(ditch.outline().shifted(dx, dy)));
            }
        }
        return changed;
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
            }
        }
        return changed;
    }

    /** Returns the name to show of an element, its id if the scene does not hold it. */
    public static String name(Scene scene, String id) {
        return scene.element(id).map(Element::name).orElse(id);
    }

    /** Returns a length in metres rounded to a tenth of a millimetre. */
    public static double rounded(double metres) {
        return Math.rint(metres * 1e4) / 1e4;
    }

    /** Returns the scene without the elements of these ids. */
    public static Scene removed(Scene scene, Collection<String> ids) {
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
        return scene.with(journey.between(place, journey.goal()));
    }

    /** Returns the scene with the journey ending elsewhere. */
    public static Scene endingAt(Scene scene, Journey journey, Place place) {
        return scene.with(journey.between(journey.start(), place));
    }

    /** Returns the scene with other preferences for the journey. */
    public static Scene preferring(Scene scene, Journey journey, Preferences preferences) {
        return scene.with(journey.preferring(preferences));
    }
}
