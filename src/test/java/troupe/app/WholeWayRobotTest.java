package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JSlider;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import troupe.app.canvas.Canvas;
import troupe.app.document.SceneDocument;
import troupe.exchange.Formats;
import troupe.geometry.Polygon;
import troupe.run.Run;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Goes the whole way of a person in one window: from the start page to a saved scene that opens again as it was. */
class WholeWayRobotTest extends RobotTest {
    private Canvas canvas() {
        return studio.window().canvas();
    }

    private SceneDocument document() {
        return studio.session().document();
    }

    private Obstacle last() {
        List<Obstacle> all = studio.scene().obstacles();
        return all.get(all.size() - 1);
    }

    private void clickAt(double x, double y) {
        Point at = studio.pixel(x, y);
        studio.click(canvas(), at.x, at.y);
    }

    private void dragFrom(double x, double y, double toX, double toY) {
        studio.drag(canvas(), studio.pixel(x, y), studio.pixel(toX, toY));
    }

    private Run awaitRun() {
        Await.until("the run of the scene that is shown has ended", () -> studio.session()
                .plan()
                .filter(p -> p.snapshot().version().equals(document().version()))
                .flatMap(p -> p.run())
                .filter(r -> !r.outcome().isRunning())
                .isPresent());
        return OnEventThread.get(() -> studio.session().run().orElseThrow());
    }

    private void openFromStartPage() {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_HOME);
        Await.until("the examples are shown", () -> studio.shows("example.unified.courtyard"));
        studio.click("example.unified.courtyard");
        Await.until("it is open", () -> document().file().isEmpty() && canvas().isShowing());
    }

    private void drawAndBend() {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_2);
        clickAt(3, 10);
        clickAt(4, 10);
        clickAt(5, 11);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        clickAt(4, 9);
        clickAt(3, 9);
        studio.keys(KeyEvent.VK_ENTER);
        assertEquals(Polygon.of(3, 10, 4, 10, 4, 9, 3, 9), last().outline());
        Polygon crate = studio.scene().obstacle("crate").orElseThrow().outline();
        double x = crate.bounds().minX();
        double y = crate.bounds().minY();
        Point near = studio.pixel(x, y);
        near.translate(3, 3);
        studio.drag(canvas(), studio.pixel(4, 9), near);
        assertEquals(Polygon.of(3, 10, 4, 10, x, y, 3, 9), last().outline(), "the corner snaps to that of the crate");
        studio.click("property.height");
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        studio.type("0.6");
        studio.keys(KeyEvent.VK_ENTER);
        assertEquals(0.6, last().height());
    }

    private void undoAndRedoAll(Scene first) {
        Scene now = studio.scene();
        int steps = OnEventThread.get(() -> document().history().names().size());
        for (int i = 0; i < steps; i++) {
            studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        }
        assertEquals(first, studio.scene());
        for (int i = 0; i < steps; i++) {
            studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        }
        assertEquals(now, studio.scene());
    }

    private void meetSomebody() {
        clickAt(1, 12);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_8);
        clickAt(3, 2);
        clickAt(3, 4);
        studio.keys(KeyEvent.VK_ENTER);
        Encounter made = (Encounter) studio.scene().task("encounter-1").orElseThrow();
        assertEquals(Place.of(3, 2), ((Avatar.Script) made.avatars().get(0).motion()).start());
        assertEquals(
                "encounter",
                awaitRun().scene().task("encounter-1").orElseThrow().kind());
    }

    private void runACrowd() {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_9);
        dragFrom(1, 1, 4, 3);
        clickAt(8, 2);
        Crowd crowd = (Crowd) studio.scene().task("crowd-1").orElseThrow();
        assertEquals(5, crowd.groups().get(0).members().orElseThrow().count());
        Run before = awaitRun();
        assertTrue(before.outcome().isFound(), before.outcome().word());
        OnEventThread.run(() -> studio.session().playback().seek(2));
        JSlider slider = (JSlider) studio.find("control.weight.cohesion");
        OnEventThread.run(() -> slider.scrollRectToVisible(new java.awt.Rectangle(slider.getSize())));
        Point knob = new Point(slider.getWidth() * slider.getValue() / slider.getMaximum(), slider.getHeight() / 2);
        studio.drag(slider, knob, new Point(slider.getWidth() - 8, knob.y));
        Await.until("the slider counts", () -> studio.session()
                .run()
                .filter(r -> !r.outcome().isRunning() && !r.inputs().isEmpty())
                .isPresent());
    }

    private void exportAGif() throws Exception {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Await.until("the dialog", () -> studio.shows("export.formats"));
        OnEventThread.run(
                () -> ((JList<?>) studio.find("export.formats")).setSelectedValue(Formats.exporter("gif"), true));
        OnEventThread.run(() -> ((JTextField) studio.find("export.target"))
                .setText(folder.resolve("crowd.gif").toString()));
        studio.click("export.width");
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        studio.type("160");
        studio.keys(KeyEvent.VK_ENTER);
        studio.click("export.write");
        Await.until(
                "written",
                () -> ((JLabel) studio.find("export.message")).getText().startsWith("Written to"));
        byte[] written = Files.readAllBytes(folder.resolve("crowd.gif"));
        assertEquals("GIF", new String(written, 0, 3, StandardCharsets.US_ASCII));
        studio.click("export.close");
        Await.until("closed", () -> !studio.shows("export.formats"));
    }

    private void search(String word, String setting, String value) {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_K);
        Await.until(
                "the search has the focus", () -> studio.find("search.query").isFocusOwner());
        studio.type(word);
        studio.keys(KeyEvent.VK_ENTER);
        Await.until(word, () -> value.equals(studio.settings().get(setting)));
        Await.until("the canvas is there", () -> canvas().isShowing() && canvas().getWidth() > 100);
    }

    private void saveAs(Path file) {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        Await.until("the file is asked for", () -> java.util.Arrays.stream(
                        studio.window().frame().getOwnedWindows())
                .anyMatch(w -> w.isShowing() && w.getFocusOwner() instanceof JTextField));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        studio.type(file.toString());
        studio.keys(KeyEvent.VK_ENTER);
        Await.until(
                "it is saved",
                () -> document().file().equals(Optional.of(file)) && !document().isUnsaved());
    }

    @Test
    void fromTheStartPageToASceneThatOpensAgainAsItWas() throws Exception {
        openFromStartPage();
        Scene first = studio.scene();
        Run before = awaitRun();
        dragFrom(8.125, 7.6, 5.5, 7);
        Run after = awaitRun();
        assertNotEquals(before.legs(), after.legs());
        drawAndBend();
        undoAndRedoAll(first);
        studio.keys(KeyEvent.VK_F9);
        assertTrue(OnEventThread.get(() -> studio.session().playback().time()) > 0);
        meetSomebody();
        runACrowd();
        exportAGif();
        clickAt(1, 12);
        search("dark", "theme", "dark");
        search("chinese", "language", "zh-TW");
        Scene last = studio.scene();
        Path file = folder.resolve("whole.xml");
        saveAs(file);
        assertEquals(last, SceneXml.read(file).scene());
        OnEventThread.run(() -> studio.session().document().open(first, Optional.empty()));
        OnEventThread.run(() -> studio.session().open(file));
        Await.until("it is open again", () -> document().file().equals(Optional.of(file)));
        assertEquals(last, studio.scene());
        assertFalse(OnEventThread.get(() -> document().isUnsaved()));
        studio.settings().put("language", "en");
    }
}
