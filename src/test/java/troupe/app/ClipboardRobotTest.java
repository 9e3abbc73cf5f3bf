package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JList;
import org.junit.jupiter.api.Test;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Copies, pastes and goes back through the history in the real window. */
class ClipboardRobotTest extends RobotTest {
    private List<String> selected() {
        return OnEventThread.get(() -> studio.session().selection().ids());
    }

    private String held() throws Exception {
        return (String) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
    }

    @Test
    void aCopyGoesThroughTheClipboardAsTheSceneFormat() throws Exception {
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection("nothing"), null);
        OnEventThread.run(() -> studio.session().selection().set(List.of("bench")));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_C);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
        Await.until(
                "pasted",
                () -> studio.session().document().scene().obstacle("bench-1").isPresent());
        assertTrue(held().contains("urn:troupe:scene:1") && held().contains("id=\"bench\""), held());
        assertEquals(List.of("bench-1"), selected());
        Obstacle copy = studio.scene().obstacle("bench-1").orElseThrow();
        assertEquals("Bench 2", copy.label());
        assertEquals(14, copy.mass());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_X);
        Await.until(
                "cut",
                () -> studio.session().document().scene().obstacle("bench-1").isEmpty());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
        Await.until("pasted in place", () -> studio.session()
                .document()
                .scene()
                .obstacle("bench-1")
                .filter(copy::equals)
                .isPresent());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
        assertEquals(List.of("bench-2"), selected());
    }

    @Test
    void aClickInTheHistoryGoesThere() {
        Scene first = studio.scene();
        OnEventThread.run(() -> studio.session().selection().set(List.of("bench")));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_H);
        Await.until("the steps are listed", () -> studio.find("history.list").isShowing());
        for (int i = 0; i < 4; i++) {
            studio.keys(KeyEvent.VK_RIGHT);
        }
        JList<?> list = (JList<?>) studio.find("history.list");
        Await.until("four steps", () -> list.getModel().getSize() == 5);
        Scene last = studio.scene();
        java.awt.Rectangle begin = OnEventThread.get(() -> list.getCellBounds(0, 0));
        studio.click(list, 30, begin.y + 8);
        assertEquals(first, studio.scene());
        java.awt.Rectangle end = OnEventThread.get(() -> list.getCellBounds(4, 4));
        studio.click(list, 30, end.y + 8);
        assertEquals(last, studio.scene());
    }

    @Test
    void thingsAreAlignedFromTheSearchForCommands() {
        OnEventThread.run(() -> studio.session().selection().set(List.of("planter-1", "bench")));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_K);
        Await.until(
                "the search has the focus", () -> studio.find("search.query").isFocusOwner());
        studio.type("align left");
        studio.keys(KeyEvent.VK_ENTER);
        Await.until(
                "aligned",
                () -> studio.session()
                                .document()
                                .scene()
                                .obstacle("bench")
                                .orElseThrow()
                                .outline()
                                .bounds()
                                .minX()
                        == 1.4);
    }

    @Test
    void somethingElseOnTheClipboardIsRefusedInWords() {
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection("hello"), null);
        Scene before = studio.scene();
        String[] told = {""};
        OnEventThread.run(() -> studio.session().notices().add(n -> told[0] = n.text()));
        Point free = studio.pixel(3, 9);
        studio.click(studio.window().canvas(), free.x, free.y);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
        Await.until("told", () -> told[0].startsWith("The clipboard holds no part of a scene"));
        assertEquals(before, studio.scene());
    }
}
