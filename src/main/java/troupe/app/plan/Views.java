package troupe.app.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import troupe.grid.GridFrame;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Holds the views of a plan, and how high each layer lies. Immutable.
 *
 * @param layers one for each layer, the lowest first; empty while there are no views
 * @param aspects the respects in which the planner has other views
 * @param current whether they are all that the planner offers of the plan that has them; else some, or all, may be
 *     missing, or those of an earlier plan, until newer ones have been made
 */
public record Views(List<Overlay> overlays, List<Layer> layers, List<Aspect> aspects, boolean current) {
    /** No views. */
    public static final Views NONE = new Views(List.of(), List.of(), List.of(), false);

    /**
     * One layer.
     *
     * @param on the id of the obstacle or ditch that its middle floor belongs to, empty for the ground
     * @param lowest its lowest floor in metres, {@code highest} its highest; NaN where they are not known
     * @param cells how many cells it has
     */
    public record Layer(String on, double lowest, double highest, int cells) {
        private static final Layer UNKNOWN = new Layer("", Double.NaN, Double.NaN, 0);
    }

    /** Copies the lists. */
    public Views {
        overlays = List.copyOf(overlays);
        layers = List.copyOf(layers);
        aspects = List.copyOf(aspects);
    }

    /** Makes all views of a scene; where a layer lies is read from the one with the key {@code elevation}. */
    public static Views of(Scene scene, List<Overlay> overlays, List<Aspect> aspects) {
        int count = 1 + overlays.stream().mapToInt(Overlay::layer).max().orElse(0);
        List<Layer> layers = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            int layer = i;
            layers.add(overlays.stream()
                    .filter(o -> o.layer() == layer && o.key().equals("elevation"))
                    .findFirst()
                    .map(o -> o instanceof Overlay.Field field ? layer(scene, field) : null)
                    .orElse(Layer.UNKNOWN));
        }
        return new Views(overlays, layers, aspects, true);
    }

    /** Makes some views of a scene. */
    public static Views some(Scene scene, List<Overlay> overlays, List<Aspect> aspects) {
        return of(scene, overlays, aspects).aged();
    }

    /** Returns the same views as those of an earlier plan; the list of overlays stays the very same. */
    public Views aged() {
        return current ? new Views(overlays, layers, aspects, false) : this;
    }

    /**
     * Returns these views and of the kinds that they lack those of an earlier plan, in whose order they are; these alone
     * if they are all there are.
     */
    public Views over(Views earlier) {
        if (current) {
            return this;
        }
        if (overlays.isEmpty()) {
            return earlier.aged();
        }
        Map<String, List<Overlay>> kinds = byKey(earlier.overlays);
        kinds.putAll(byKey(overlays));
        List<Overlay> merged = kinds.values().stream().flatMap(List::stream).toList();
        boolean raised = overlays.stream().anyMatch(o -> o.key().equals("elevation"));
        return new Views(merged, raised ? layers : earlier.layers, aspects, false);
    }

    private static Map<String, List<Overlay>> byKey(List<Overlay> overlays) {
        return overlays.stream().collect(Collectors.groupingBy(Overlay::key, LinkedHashMap::new, Collectors.toList()));
    }

    private static Layer layer(Scene scene, Overlay.Field elevation) {
        float[] values = elevation.values();
        int cells = 0;
        float[] floors = new float[values.length];
        for (float value : values) {
            if (!Float.isNaN(value)) {
                floors[cells++] = value;
            }
        }
        if (cells == 0) {
            return Layer.UNKNOWN;
        }
        Arrays.sort(floors, 0, cells);
        float middle = floors[cells / 2];
        int at = 0;
        while (values[at] != middle) {
            at++;
        }
        GridFrame frame = elevation.frame();
        String on = on(scene, frame.centreX(frame.col(at)), frame.centreY(frame.row(at)), middle);
        return new Layer(on, floors[0], floors[cells - 1], cells);
    }

    private static String on(Scene scene, double x, double y, double floor) {
        Stream<Element> under = scene.elements()
                .filter(e -> e instanceof Obstacle o
                                && near(o.top(), floor)
                                && o.outline().contains(x, y)
                        || e instanceof Ditch d
                                && near(-d.depth(), floor)
                                && d.outline().contains(x, y));
        return under.findFirst().map(Element::id).orElse("");
    }

    private static boolean near(double a, double b) {
        return Math.abs(a - b) < 1e-3;
    }
}
