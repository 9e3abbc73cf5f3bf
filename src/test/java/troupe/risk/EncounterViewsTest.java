package troupe.risk;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.run.Run;
import troupe.run.view.Ahead;
import troupe.run.view.Overlay;
import troupe.run.view.Strip;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Checks the views of an encounter: a saved run shows what the engine showed, and the masses are right. */
class EncounterViewsTest {

    private static Scene scene(String name) throws Exception {
        return SceneXml.read(Path.of("scenes/risk/" + name + ".xml")).scene();
    }

    private static float[] field(List<Overlay> views, String key) {
        return ((Overlay.Field) views.stream()
                        .filter(o -> o.key().equals(key))
                        .findFirst()
                        .orElseThrow())
                .values();
    }

    @Test
    void theRunAloneShowsWhatTheEngineShowed() throws Exception {
        Scene scene = scene("crossing");
        EncounterEngine engine =
                EncounterEngine.of(scene, (Encounter) scene.tasks().get(0));
        for (int k = 0; k < 80; k++) {
            engine.step(1);
        }
        for (int choice = 0; choice < Ahead.SECONDS.size(); choice++) {
            List<Overlay> live = engine.overlays(List.of(choice));
            List<Overlay> saved = new EncounterViews(engine.run()).overlays(79, Ahead.SECONDS.get(choice));
            assertEquals(
                    live.stream().map(Overlay::key).toList(),
                    saved.stream().map(Overlay::key).toList());
            assertArrayEquals(field(live, "probability"), field(saved, "probability"));
            assertArrayEquals(field(live, "risk"), field(saved, "risk"));
        }
    }

    @Test
    void theProbabilityShownAddsUpToThoseWhoAreThere() throws Exception {
        Scene scene = scene("plaza");
        Run run = EncounterEngine.of(scene, (Encounter) scene.tasks().get(0)).finish();
        EncounterViews views = new EncounterViews(run);
        double area = scene.world().cell() * scene.world().cell();
        for (double ahead : Ahead.SECONDS) {
            double sum = 0;
            for (float density : field(views.overlays(60, ahead), "probability")) {
                sum += Float.isNaN(density) ? 0 : density * area;
            }
            assertEquals(3, sum, 0.03, ahead + " s ahead");
        }
    }

    @Test
    void theStripTellsWhenThePlanMeetsWhom() throws Exception {
        Scene scene = scene("crossing");
        Run run = EncounterEngine.of(scene, (Encounter) scene.tasks().get(0)).finish();
        Strip strip = new EncounterViews(run).strip(90);
        assertEquals(List.of("Bob"), strip.names());
        double[] row = strip.rows().get(0);
        int highest = 0;
        for (int k = 0; k < row.length; k++) {
            assertTrue(Double.isNaN(row[k]) || row[k] >= 0 && row[k] <= 1);
            highest = row[k] > row[highest] ? k : highest;
        }
        assertTrue(highest > 3 && row[highest] > row[0], "most likely after " + highest + " steps");
    }

    @Test
    void cautionBuysLessRiskForMoreLength() throws Exception {
        Scene scene = scene("influence");
        Encounter near = (Encounter) scene.task("toward").orElseThrow();
        List<TradeOff.Choice> choices =
                TradeOff.of(scene.with(near), near.with(Quantity.RATE, 10), List.of(0.0, 0.5, 4.0));
        assertEquals(3, choices.size());
        for (int k = 1; k < choices.size(); k++) {
            TradeOff.Choice less = choices.get(k - 1);
            TradeOff.Choice more = choices.get(k);
            assertTrue(more.risk() <= less.risk() + 0.02, choices::toString);
            assertTrue(more.seconds() >= less.seconds() - 0.02, choices::toString);
        }
        assertTrue(choices.get(2).risk() < choices.get(0).risk() - 0.05, choices::toString);
    }
}
