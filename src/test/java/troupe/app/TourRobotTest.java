package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.paint.Theme;

/** Takes the tour with mouse and keys. */
class TourRobotTest {
    @TempDir
    Path folder;

    private StudioFixture studio;

    @BeforeEach
    void open() throws Exception {
        Assumptions.assumeFalse(GraphicsEnvironment.isHeadless(), "skipped: there is no display");
        Path file = Files.copy(Path.of("scenes/unified/walk.xml"), folder.resolve("walk.xml"));
        studio = new StudioFixture(folder, file, Map.of("tour", "false"));
    }

    @AfterEach
    void close() {
        if (studio != null) {
            studio.close();
        }
    }

    private String step() {
        return OnEventThread.get(() -> studio.window().tour().step());
    }

    private String text(String name) {
        return OnEventThread.get(() -> ((JTextArea) studio.find(name)).getText());
    }

    private void begin() {
        OnEventThread.run(() -> studio.window().commands().get("startpage").perform());
        Await.until("the start page", () -> studio.shows("start.tour"));
        studio.click("start.tour");
        Await.until(
                "the courtyard and the card",
                () -> studio.window().tour().isOn()
                        && studio.session().document().scene().obstacle("crate").isPresent());
        studio.awaitPlan();
    }

    private void awaitDone(String next) {
        Await.until("the step is done", () -> studio.shows("tour.next"));
        assertNotEquals("", text("tour.done"));
        studio.click("tour.next");
        assertEquals(next, step());
        assertFalse(studio.shows("tour.next"), "what is still to be done is not done yet");
    }

    @Test
    void theTourWaitsUntilEachThingIsReallyDone() {
        begin();
        assertEquals("welcome", step());
        studio.click("tour.next");
        assertEquals("crate", step());
        assertFalse(studio.shows("tour.next"));
        assertTrue(studio.shows("tour.mark"));
        studio.drag(studio.window().canvas(), studio.pixel(8.125, 7.6), studio.pixel(5.5, 9.5));
        awaitDone("why");
        Component slider = studio.find("preference.vault");
        int middle = slider.getHeight() / 2;
        studio.drag(slider, new Point(slider.getWidth() / 2, middle), new Point(slider.getWidth() - 5, middle));
        awaitDone("undo");
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        awaitDone("views");
        studio.click(studio.shows("chip.potential") ? "chip.potential" : "chip.plan");
        awaitDone("play");
        studio.keys(KeyEvent.VK_F9);
        awaitDone("draw");
        studio.click("tool.rectangle");
        studio.drag(studio.window().canvas(), studio.pixel(2, 4), studio.pixel(6, 4.5));
        awaitDone("height");
        studio.click("property.height");
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        studio.type("0.8");
        studio.keys(KeyEvent.VK_ENTER);
        awaitDone("search");
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_K);
        Await.until("the search was opened", () -> studio.shows("tour.next"));
        studio.keys(KeyEvent.VK_ESCAPE);
        studio.click("tour.next");
        assertEquals("end", step());
        studio.click("tour.end");
        assertFalse(studio.shows("tour"));
        assertEquals("true", studio.settings().get("tour"));
    }

    @Test
    void theTourIsTakenByKeysAndSurvivesAnotherThemeAndLanguage() {
        begin();
        assertEquals(
                "tour.next",
                OnEventThread.get(
                        () -> studio.window().frame().getMostRecentFocusOwner().getName()));
        studio.keys(KeyEvent.VK_SPACE);
        assertEquals("crate", step());
        studio.keys(KeyEvent.VK_SPACE);
        assertEquals("why", step());
        studio.keys(KeyEvent.VK_SHIFT, KeyEvent.VK_TAB);
        studio.keys(KeyEvent.VK_SPACE);
        assertEquals("crate", step());
        String english = text("tour.text");
        OnEventThread.run(() -> studio.window().show(Theme.DARK));
        assertEquals(english, text("tour.text"));
        OnEventThread.run(() -> studio.window().commands().get("chinese").perform());
        assertEquals("crate", step());
        assertNotEquals(english, text("tour.text"));
        studio.click("tour.close");
        assertFalse(studio.shows("tour"));
        assertFalse(studio.shows("tour.mark"));
    }

    @Test
    void theTourIsOfferedOnceAndNotAgainWhenDeclined() {
        OnEventThread.run(() -> studio.window().tour().offer(studio.window().pages()::tour));
        Await.until("the offer", () -> studio.shows("tour.take"));
        assertEquals("", step());
        studio.click("tour.later");
        assertFalse(studio.shows("tour"));
        OnEventThread.run(() -> studio.window().tour().offer(studio.window().pages()::tour));
        assertFalse(studio.shows("tour"));
    }
}
