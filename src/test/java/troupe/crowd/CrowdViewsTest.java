package troupe.crowd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.crowd.flock.Sweep;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.scene.Crowd;
import troupe.scene.Scene;

class CrowdViewsTest {
    private static CrowdEngine bridge() throws Exception {
        Scene scene = CrowdEngineTest.scene("narrow-bridge");
        return new CrowdEngine(scene, (Crowd) scene.tasks().get(0), Sweep.alone());
    }

    @Test
    void thereIsNothingToSeeBeforeAnybodyStands() throws Exception {
        CrowdEngine engine = bridge();
        assertEquals(List.of(), engine.overlays());
        assertEquals(List.of(), engine.aspects(List.of()));
    }

    @Test
    void eachGoalHasAPotentialOfItsOwn() throws Exception {
        CrowdEngine engine = bridge();
        engine.step(1);
        Aspect goals = engine.aspects(List.of()).get(0);
        assertEquals(
                List.of("goal red +1 (13.0, 36.0)", "goal blue +1 (13.0, 3.0)"),
                goals.choices().stream().map(Aspect.Choice::text).toList());
        double[] ys = {36, 3};
        for (int choice = 0; choice < 2; choice++) {
            List<Overlay> shown = engine.overlays(List.of(choice), "potential"::equals);
            Overlay.Field field = (Overlay.Field) shown.stream()
                    .filter(o -> o instanceof Overlay.Field)
                    .findFirst()
                    .orElseThrow();
            assertTrue(shown.stream().allMatch(o -> o.key().equals("potential")));
            assertEquals(0, field.values()[field.frame().cellAt(13, ys[choice])]);
            assertTrue(field.values()[field.frame().cellAt(13, ys[1 - choice])] > 30);
        }
    }

    @Test
    void oneGoalLeavesNothingToChoose() throws Exception {
        Scene scene = CrowdEngineTest.scene("fork");
        CrowdEngine engine = new CrowdEngine(scene, (Crowd) scene.tasks().get(0), Sweep.alone());
        engine.step(1);
        assertEquals(List.of(), engine.aspects(List.of()));
        assertEquals(1, engine.overlays(List.of(), "clearance"::equals).size());
    }
}
