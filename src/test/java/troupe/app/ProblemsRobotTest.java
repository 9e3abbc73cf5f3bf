package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import troupe.app.document.SceneEdits;
import troupe.paint.Viewport;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Breaks the courtyard, reads what is wrong, and mends it with the buttons of the real window. */
class ProblemsRobotTest extends RobotTest {
    private void commit(Scene changed) {
        OnEventThread.run(() -> studio.session().document().commit("break", changed));
    }

    private void awaitButton(String name) {
        Await.until("the button " + name, () -> {
            try {
                return studio.find(name).isShowing();
            } catch (AssertionError notYet) {
                return false;
            }
        });
    }

    @Test
    void aStartInAWallIsToldAndMovedOutWithAClick() {
        assertFalse(studio.find("problems").isVisible());
        Scene scene = studio.scene();
        Journey journey = (Journey) scene.task("to-the-fountain").orElseThrow();
        commit(SceneEdits.startingAt(scene, journey, Place.of(8.1, 5.5)));
        awaitButton("fix.start");
        studio.click("fix.start");
        assertTrue(studio.awaitPlan().run().orElseThrow().outcome().isFound());
        Await.until("nothing is wrong any more", () -> !studio.find("problems").isVisible());
        assertEquals(
                List.of("break", "Move the start to the nearest free place"),
                OnEventThread.get(() -> studio.session().document().history().names()));
    }

    @Test
    void whereThereIsNoWayWhatBlocksItIsNamedAndCanBeMadeToGiveWay() {
        Scene scene = studio.scene();
        Scene shut = scene.with(scene.obstacle("crate")
                .map(o -> new troupe.scene.Obstacle(o.id(), o.label(), o.outline(), 0, 3, false, o.mass(), o.colour()))
                .orElseThrow());
        commit(shut);
        awaitButton("fix.movable");
        String text = OnEventThread.get(() -> ((JTextComponent) studio.find("problem")).getText());
        assertTrue(text.contains("Crate"), text);
        Viewport before = OnEventThread.get(() -> studio.window().canvas().view());
        studio.click("problem");
        Await.until("the view goes there", () -> studio.window().canvas().view().scale() > 1.5 * before.scale());
        studio.click("fix.movable");
        assertTrue(studio.awaitPlan().run().orElseThrow().outcome().isFound());
    }
}
