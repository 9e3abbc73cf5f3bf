package troupe.app.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.look.Texts;
import troupe.app.plan.Plan;
import troupe.app.session.OverlayChoice;
import troupe.geometry.Point;
import troupe.run.view.Overlay;

/** Reads the values of the planner's views at a place. Pure; cost O(views). */
final class PointerReadout {
    private PointerReadout() {}

    /** One value in words. */
    record Value(String key, String text) {}

    /**
     * Returns the value of each field at a place, one per kind: of the layer looked at, or of the
     * highest one that has a value there.
     */
    static List<Value> at(Plan plan, Point place, OverlayChoice choice, Texts texts) {
        List<Value> values = new ArrayList<>();
        List<Overlay.Field> fields = new ArrayList<>();
        for (Overlay overlay : plan.overlays()) {
            boolean looked = choice.layer() == OverlayChoice.ALL_LAYERS || choice.layer() == overlay.layer();
            if (looked && overlay instanceof Overlay.Field field) {
                fields.add(field);
            }
        }
        for (String key : fields.stream().map(Overlay.Field::key).distinct().toList()) {
            fields.stream()
                    .filter(f -> f.key().equals(key))
                    .map(f -> text(f, place, texts).map(text -> new Found(f.layer(), text)))
                    .flatMap(Optional::stream)
                    .max(java.util.Comparator.comparingInt(Found::layer))
                    .ifPresent(found -> values.add(new Value(key, found.text())));
        }
        return values;
    }

    private record Found(int layer, String text) {}

    private static Optional<String> text(Overlay.Field field, Point place, Texts texts) {
        int cell = field.frame().cellAt(place.x(), place.y());
        if (cell < 0 || cell >= field.values().length || Float.isNaN(field.values()[cell])) {
            return Optional.empty();
        }
        float value = field.values()[cell];
        if (field.scale() instanceof Overlay.Categories categories) {
            int index = (int) value;
            boolean known = index >= 0 && index < categories.words().size();
            return known
                    ? Optional.of(texts.get(
                            "word." + categories.words().get(index),
                            categories.words().get(index)))
                    : Optional.empty();
        }
        String unit = ((Overlay.Continuous) field.scale()).unit();
        return Float.isInfinite(value)
                ? Optional.empty()
                : Optional.of(Texts.number(value, 2) + (unit.isEmpty() ? "" : " " + unit));
    }
}
