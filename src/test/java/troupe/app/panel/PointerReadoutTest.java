package troupe.app.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.document.Version;
import troupe.app.look.Texts;
import troupe.app.panel.PointerReadout.Value;
import troupe.app.plan.Live;
import troupe.app.plan.Plan;
import troupe.app.plan.Snapshot;
import troupe.app.plan.Views;
import troupe.app.session.OverlayChoice;
import troupe.geometry.Point;
import troupe.grid.GridFrame;
import troupe.run.view.Overlay;
import troupe.scene.Scene;

class PointerReadoutTest {
    private static final float NONE = Float.NaN;
    private final GridFrame frame = new GridFrame(0, 0, 1, 2, 2);

    private Plan plan() {
        Overlay.Scale metres = new Overlay.Continuous("m", 0, 5, 0);
        Overlay.Scale words = new Overlay.Categories(List.of("stable", "border"));
        List<Overlay> overlays = List.of(
                new Overlay.Field("clearance", 0, frame, new float[] {1, 2, 3, NONE}, metres),
                new Overlay.Field("clearance", 1, frame, new float[] {NONE, 0.5f, NONE, NONE}, metres),
                new Overlay.Field("class", 0, frame, new float[] {0, 1, NONE, 9}, words),
                new Overlay.Field("potential", 0, frame, new float[] {Float.POSITIVE_INFINITY, 1, 1, 1}, metres));
        Scene scene = Scenes.room();
        Snapshot snapshot = new Snapshot(new Version(1, 0), scene, "there");
        return new Plan(
                snapshot,
                Optional.empty(),
                List.of(),
                Views.of(scene, overlays, List.of()),
                Optional.empty(),
                Live.NONE,
                1);
    }

    private List<Value> at(double x, double y, int layer) {
        return OnEventThread.get(() -> {
            OverlayChoice choice = new OverlayChoice(List.of());
            choice.lookAt(layer);
            return PointerReadout.at(plan(), new Point(x, y), choice, new Texts(Locale.ENGLISH));
        });
    }

    @Test
    void readsTheHighestLayerThatHasAValue() {
        assertEquals(
                List.of(new Value("clearance", "1.00 m"), new Value("class", "stable")),
                at(0.5, 0.5, OverlayChoice.ALL_LAYERS));
        assertEquals(
                new Value("clearance", "0.50 m"),
                at(1.5, 0.5, OverlayChoice.ALL_LAYERS).get(0));
    }

    @Test
    void readsTheLayerLookedAt() {
        assertEquals(new Value("clearance", "2.00 m"), at(1.5, 0.5, 0).get(0));
        assertEquals(List.of(new Value("clearance", "0.50 m")), at(1.5, 0.5, 1));
    }

    @Test
    void readsNothingOutsideAndNothingUnknown() {
        assertEquals(List.of(), at(-1, 0.5, OverlayChoice.ALL_LAYERS));
        assertEquals(List.of(new Value("potential", "1.00 m")), at(1.5, 1.5, OverlayChoice.ALL_LAYERS));
    }
}
