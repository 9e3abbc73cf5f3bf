package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Types into the inspector of the real window. */
class InspectorRobotTest extends RobotTest {
    private void type(String field, String text) {
        studio.click(field);
        Await.until("the field has the focus", () -> studio.find(field).isFocusOwner());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        studio.type(text);
    }

    private double height(String id) {
        return studio.scene().obstacle(id).orElseThrow().height();
    }

    @Test
    void aHeightIsTypedForSeveralAtOnceAndOneUndoTakesItBack() {
        OnEventThread.run(() -> studio.session().selection().set(List.of("planter-1", "planter-2")));
        type("property.height", "0.9");
        studio.keys(KeyEvent.VK_ENTER);
        Await.until("both are higher", () -> height("planter-1") == 0.9 && height("planter-2") == 0.9);
        assertTrue(studio.find("property.height").isFocusOwner(), "the field keeps the focus");
        assertEquals(
                List.of("Height of 2 things"),
                OnEventThread.get(() -> studio.session().document().history().names()));
        OnEventThread.run(() -> studio.session().document().history().stepBack());
        assertEquals(0.6, height("planter-1"));
        assertEquals(0.6, height("planter-2"));
    }

    @Test
    void whatIsTypedGoesToTheThingItWasTypedForWhenAnotherIsClicked() {
        OnEventThread.run(() -> studio.session().selection().set(List.of("crate")));
        type("property.height", "1.1");
        Point bench = studio.pixel(14, 9.4);
        studio.click(studio.window().canvas(), bench.x, bench.y);
        Await.until("the crate is lower", () -> height("crate") == 1.1);
        assertEquals(0.45, height("bench"));
        assertEquals(
                List.of("bench"),
                OnEventThread.get(() -> studio.session().selection().ids()));
    }

    @Test
    void anActorWithoutAnAbilityIsPlannedWithoutIt() {
        OnEventThread.run(() -> studio.session().selection().set(List.of("ann")));
        OnEventThread.run(() -> ((javax.swing.AbstractButton) studio.find("property.has.vault")).doClick());
        assertTrue(studio.scene().actor("ann").orElseThrow().vault().isEmpty());
        assertTrue(studio.awaitPlan().run().orElseThrow().legs().stream()
                .noneMatch(leg -> leg.ability().equals("vault")));
    }
}
