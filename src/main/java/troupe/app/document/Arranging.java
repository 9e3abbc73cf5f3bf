package troupe.app.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Aligns things with each other, spreads them evenly, and puts them before or behind others in the document. Pure. */
public final class Arranging {
    private Arranging() {}

    /** Where things are brought to. */
    public enum Side {
        LEFT,
        MIDDLE,
        RIGHT,
        TOP,
        CENTRE,
        BOTTOM
    }

    /** Where in the order of the document things are put. */
    public enum Order {
        FRONT,
        FORWARD,
        BACKWARD,
        BACK
    }

    private static List<Element> shapes(Scene scene, List<String> ids) {
        return ids.stream()
                .flatMap(id -> scene.element(id).stream())
                .filter(e -> e instanceof Obstacle || e instanceof Ditch)
                .toList();
    }

    private static Polygon outline(Element element) {
        return element instanceof Obstacle obstacle ? obstacle.outline() : ((Ditch) element).outline();
    }

    /** Returns the scene with these things brought to one side of the box around all of them. */
    public static Scene aligned(Scene scene, List<String> ids, Side side) {
        List<Element> shapes = shapes(scene, ids);
        if (shapes.size() < 2) {
            return scene;
        }
        double minX = least(shapes, Box::minX);
        double minY = least(shapes, Box::minY);
        double maxX = -least(shapes, b -> -b.maxX());
        double maxY = -least(shapes, b -> -b.maxY());
        Scene changed = scene;
        for (Element element : shapes) {
            Box box = outline(element).bounds();
            double dx =
                    switch (side) {
                        case LEFT -> minX - box.minX();
                        case MIDDLE -> (minX + maxX - box.minX() - box.maxX()) / 2;
                        case RIGHT -> maxX - box.maxX();
                        default -> 0;
                    };
            double dy =
                    switch (side) {
                        case TOP -> maxY - box.maxY();
                        case CENTRE -> (minY + maxY - box.minY() - box.maxY()) / 2;
                        case BOTTOM -> minY - box.minY();
                        default -> 0;
                    };
            changed = changed.with(shifted(element, dx, dy));
        }
        return changed;
    }

    /** Returns the scene with the middles of these things at equal distances between the outermost two. */
    public static Scene spread(Scene scene, List<String> ids, boolean across) {
        Function<Element, Double> middle = e -> {
            Box box = outline(e).bounds();
            return (across ? box.minX() + box.maxX() : box.minY() + box.maxY()) / 2;
        };
        List<Element> shapes = new ArrayList<>(shapes(scene, ids));
        if (shapes.size() < 3) {
            return scene;
        }
        shapes.sort(Comparator.comparing(middle));
        double first = middle.apply(shapes.get(0));
        double step = (middle.apply(shapes.get(shapes.size() - 1)) - first) / (shapes.size() - 1);
        Scene changed = scene;
        for (int i = 0; i < shapes.size(); i++) {
            double by = first + i * step - middle.apply(shapes.get(i));
            changed = changed.with(shifted(shapes.get(i), across ? by : 0, across ? 0 : by));
        }
        return changed;
    }

    private static double least(List<Element> shapes, Function<Box, Double> of) {
        return shapes.stream()
                .mapToDouble(e -> of.apply(outline(e).bounds()))
                .min()
                .orElseThrow();
    }

    private static Element shifted(Element element, double dx, double dy) {
        return dx == 0 && dy == 0
                ? element
                : SceneEdits.reshaped(
                        element, SceneEdits.rounded(outline(element).shifted(dx, dy)));
    }

    /** Returns the scene with these obstacles and ditches moved in the order of the document; the last lies in front. */
    public static Scene ordered(Scene scene, List<String> ids, Order order) {
        return new Scene(
                scene.title(),
                scene.world(),
                ordered(scene.obstacles(), ids, order),
                ordered(scene.ditches(), ids, order),
                scene.actors(),
                scene.tasks());
    }

    private static <E extends Element> List<E> ordered(List<E> all, List<String> ids, Order order) {
        List<E> moved = new ArrayList<>(all);
        int n = moved.size();
        switch (order) {
            case FRONT -> moved.sort(Comparator.comparing(e -> ids.contains(e.id())));
            case BACK -> moved.sort(Comparator.comparing(e -> !ids.contains(e.id())));
            case FORWARD -> {
                for (int i = n - 2; i >= 0; i--) {
                    swapIf(moved, i, i + 1, ids);
                }
            }
            case BACKWARD -> {
                for (int i = 1; i < n; i++) {
                    swapIf(moved, i, i - 1, ids);
                }
            }
        }
        return moved;
    }

    private static <E extends Element> void swapIf(List<E> all, int i, int with, List<String> ids) {
        if (ids.contains(all.get(i).id()) && !ids.contains(all.get(with).id())) {
            java.util.Collections.swap(all, i, with);
        }
    }
}
