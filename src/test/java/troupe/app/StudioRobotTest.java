package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.app.plan.Plan;
import troupe.app.play.Figures;
import troupe.paint.Viewport;
import troupe.run.Run;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Works the real window with mouse and keys, on a real or a virtual display. */
class StudioRobotTest extends RobotTest {
    /** The middle of the crate, which stands in the door of the yard, and a place out of everyone's way, in metres. */
    private static final double[] CRATE = {8.125, 7.6};

    private static final double[] ASIDE = {5.5, 9.5};

    private Point at(double[] place) {
        return studio.pixel(place[0], place[1]);
    }

    private Run run() {
        return studio.awaitPlan().run().orElseThrow();
    }

    @Test
    void aDraggedCrateChangesThePlanAndUndoBringsItBack() {
        Scene before = studio.scene();
        Run first = run();
        assertTrue(first.outcome().isFound());
        studio.drag(studio.window().canvas(), at(CRATE), at(ASIDE));
        Run second = run();
        assertNotEquals(before, studio.scene());
        assertNotEquals(
                first.legs().size() + Figures.energy(first), second.legs().size() + Figures.energy(second));
        Scene after = studio.scene();
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        Await.until("undone", () -> studio.session().document().scene().equals(before));
        assertEquals(Figures.energy(first), Figures.energy(run()));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        Await.until("done again", () -> studio.session().document().scene().equals(after));
        assertEquals(Figures.energy(second), Figures.energy(run()));
        assertEquals(
                List.of("Move Crate"),
                OnEventThread.get(() -> studio.session().document().history().names()));
    }

    @Test
    void thePlanFollowsWhileTheMouseIsDownAndEscapeLeavesNoTrace() {
        Scene before = studio.scene();
        double energy = Figures.energy(run());
        studio.pressAndMove(studio.window().canvas(), at(CRATE), at(ASIDE));
        Await.until(
                "a plan of a moment of the gesture",
                () -> studio.session().plan().orElseThrow().snapshot().version().preview() > 0);
        assertEquals(before, studio.scene());
        studio.keys(KeyEvent.VK_ESCAPE);
        studio.release();
        assertEquals(before, studio.scene());
        assertEquals(energy, Figures.energy(run()));
        assertFalse(
                OnEventThread.get(() -> studio.session().document().history().canUndo()));
    }

    private static boolean movesTheCrate(Run run) {
        return run.legs().stream()
                .anyMatch(leg -> leg.ability().equals("move") && leg.what().equals("crate"));
    }

    @Test
    void theCrateIsMovedByThePlanOnlyWhileItBarsTheDoor() {
        assertTrue(movesTheCrate(run()));
        studio.pressAndMove(studio.window().canvas(), at(CRATE), at(ASIDE));
        Await.until("the plan of a moment of the gesture leaves it alone", () -> {
            Plan plan = studio.session().plan().orElseThrow();
            return plan.snapshot().version().preview() > 0
                    && !movesTheCrate(plan.run().orElseThrow());
        });
        studio.release();
        Run aside = run();
        assertFalse(movesTheCrate(aside));
        assertTrue(aside.outcome().isFound());
        studio.drag(studio.window().canvas(), at(ASIDE), studio.pixel(8.3, 7.6));
        Run back = run();
        assertTrue(movesTheCrate(back));
        assertTrue(Figures.energy(back) > Figures.energy(aside));
        Await.until(
                "the panel says so",
                () -> OnEventThread.get(() -> studio.find("why.note") instanceof javax.swing.JTextArea note
                        && note.getText().startsWith("Moves Crate over ")));
    }

    @Test
    void theViewsOfASearchSpaceAreChosenAboveTheScene() {
        studio.awaitPlan();
        OnEventThread.run(() -> studio.session().overlays().show("region", true));
        studio.click("aspect.space");
        Await.until("the spaces are offered", () -> studio.find("choices.space").isShowing());
        studio.keys(KeyEvent.VK_DOWN);
        studio.keys(KeyEvent.VK_ENTER);
        Await.until(
                "the region of that space",
                () -> OnEventThread.get(
                                () -> studio.session().overlays().chosen().equals(List.of(1)))
                        && ((javax.swing.AbstractButton) studio.find("aspect.space"))
                                .getText()
                                .endsWith("Crate moved"));
    }

    @Test
    void aSavedSceneReadsBackEqual() throws Exception {
        studio.drag(studio.window().canvas(), at(CRATE), studio.pixel(4, 8.5));
        assertTrue(OnEventThread.get(() -> studio.session().document().isUnsaved()));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        Await.until("saved", () -> !studio.session().document().isUnsaved());
        Scene saved = studio.scene();
        assertEquals(saved, SceneXml.read(studio.file()).scene());
        OnEventThread.run(() -> studio.session().open(studio.file()));
        Await.until("opened anew", () -> studio.session().document().scene() != saved);
        assertEquals(saved, studio.scene());
        assertTrue(run().outcome().isFound());
    }

    @Test
    void theOutlineComesBackAsWideAsItWas() {
        Component outline = studio.find("outline");
        resize(1_280);
        Await.until("the outline is shown", outline::isShowing);
        int width = OnEventThread.get(outline::getWidth);
        resize(1_100);
        Await.until("the outline is hidden", () -> !outline.isShowing());
        resize(1_280);
        Await.until("the outline is shown again", outline::isShowing);
        Await.until("as wide as it was", () -> outline.getWidth() == width);
    }

    private void resize(int width) {
        OnEventThread.run(() -> studio.window().frame().setSize(width, 720));
        Await.until(
                "the window is resized",
                () -> studio.window().canvas().getRootPane().getWidth() == width);
    }

    @Test
    void spacePlaysAndPausesWhereverTheFocusIs() {
        run();
        studio.keys(KeyEvent.VK_SPACE);
        Await.until("playing", () -> studio.session().playback().isPlaying());
        Component view = studio.find("timeline.view");
        OnEventThread.run(view::requestFocusInWindow);
        Await.until("the timeline has the focus", view::isFocusOwner);
        studio.keys(KeyEvent.VK_SPACE);
        Await.until("paused", () -> !studio.session().playback().isPlaying());
    }

    @Test
    void theTimelinePlaysAndScrubs() {
        run();
        studio.click("transport.play");
        Await.until(
                "half a second has been played",
                () -> studio.session().playback().time() > 0.5);
        studio.click("transport.play");
        assertFalse(OnEventThread.get(() -> studio.session().playback().isPlaying()));
        Component view = studio.find("timeline.view");
        Point middle = new Point(view.getWidth() / 2, 30);
        studio.drag(view, new Point(view.getWidth() / 4, 30), middle);
        double share = OnEventThread.get(() ->
                studio.session().playback().time() / studio.session().playback().duration());
        assertEquals(0.5, share, 0.01);
        studio.keys(KeyEvent.VK_RIGHT);
        assertTrue(OnEventThread.get(() -> studio.session().playback().time()
                        / studio.session().playback().duration())
                > share);
    }

    @Test
    void aChipShowsAViewAndTheStatusItsValue() {
        Plan plan = studio.awaitPlan();
        assertTrue(plan.overlays().stream().anyMatch(o -> o.key().equals("clearance")));
        Component canvas = studio.window().canvas();
        Point open = studio.pixel(12, 1);
        BufferedImage before = studio.picture(canvas);
        Color floor = new Color(before.getRGB(open.x, open.y));
        studio.click("chip.clearance");
        Await.until("the floor is coloured", () -> {
            BufferedImage now = new BufferedImage(canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
            canvas.paint(now.createGraphics());
            return !new Color(now.getRGB(open.x, open.y)).equals(floor);
        });
        assertTrue(StudioFixture.difference(before, studio.picture(canvas)) > 0.2);
        studio.moveTo(canvas, open.x, open.y);
        Await.until("the status tells the clearance", () -> ((javax.swing.JLabel) studio.find("status.values"))
                .getText()
                .contains("clearance "));
    }

    @Test
    void theSearchSwitchesToTheDarkThemeAndTheDocumentStays() {
        Scene before = studio.scene();
        BufferedImage light = studio.picture(studio.window().canvas());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_K);
        Await.until(
                "the search has the focus", () -> studio.find("search.query").isFocusOwner());
        studio.type("dark");
        studio.keys(KeyEvent.VK_ENTER);
        Await.until("the theme is dark", () -> "dark".equals(studio.settings().get("theme")));
        Await.until(
                "the canvas is there",
                () -> studio.window().canvas().isShowing()
                        && studio.window().canvas().getWidth() > 100);
        BufferedImage dark = studio.picture(studio.window().canvas());
        assertTrue(new Color(dark.getRGB(3, 60)).getRed() < 60);
        assertTrue(new Color(light.getRGB(3, 60)).getRed() > 200);
        assertEquals(before, studio.scene());
    }

    @Test
    void theWheelZoomsAtThePointer() {
        Component canvas = studio.window().canvas();
        Viewport before = OnEventThread.get(() -> studio.window().canvas().view());
        studio.moveTo(canvas, 200, 300);
        studio.wheel(-3);
        Viewport after = OnEventThread.get(() -> studio.window().canvas().view());
        assertTrue(after.scale() > 1.3 * before.scale());
        assertEquals(before.x(200), after.x(200), 1e-9);
        assertEquals(before.y(300), after.y(300), 1e-9);
    }
}
