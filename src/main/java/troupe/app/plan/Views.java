package troupe.app.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import troupe.grid.GridFrame;
import troupe.run.Aspect;
import troupe.run.Overlay;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Holds the views of a plan, and how high each layer lies. Immutable.
 *
 * @param layers one for each layer, the lowest first; empty while there are no views
 * @param aspects the respects in which the planner has other views
 */
public record Views(List<Overlay> overlays, List<Layer> layers, List<Aspect> aspects) {
    /** No views. */
    public static final Views NONE = new Views(List.of(), List.of(), List.of());

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

    /** Makes the views of a scene; where a layer lies is read from the one with the key {@code elevation}. */
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
        return new Views(overlays, layers, aspects);
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
