package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import troupe.app.canvas.Canvas;
import troupe.geometry.Polygon;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Draws and bends things in the real window with mouse and keys. */
class DrawingRobotTest extends RobotTest {
    private Canvas canvas() {
        return studio.window().canvas();
    }

    private void clickAt(double x, double y) {
        Point at = studio.pixel(x, y);
        studio.click(canvas(), at.x, at.y);
    }

    private void dragFrom(double x, double y, double toX, double toY) {
        studio.drag(canvas(), studio.pixel(x, y), studio.pixel(toX, toY));
    }

    private List<String> steps() {
        return OnEventThread.get(() -> studio.session().document().history().names());
    }

    private Polygon drawn() {
        List<Obstacle> all = studio.scene().obstacles();
        return all.get(all.size() - 1).outline();
    }

    private String tool() {
        return OnEventThread.get(() -> canvas().tool().key());
    }

    @Test
    void aPolygonIsDrawnCornerByCornerAndUndoTakesTheLastOneBack() {
        Scene before = studio.scene();
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_2);
        assertEquals("polygon", tool());
        clickAt(3, 10.6);
        clickAt(4.5, 10.6);
        clickAt(5, 10.2);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        clickAt(4.5, 9.6);
        clickAt(3, 9.6);
        assertEquals(before, studio.scene());
        studio.keys(KeyEvent.VK_ENTER);
        assertEquals(Polygon.of(3, 10.6, 4.5, 10.6, 4.5, 9.6, 3, 9.6), drawn());
        assertEquals(List.of("Draw Obstacle 1"), steps());
        assertEquals("select", tool());
        assertEquals(
                List.of("obstacle-1"),
                OnEventThread.get(() -> studio.session().selection().ids()));
        dragFrom(4.5, 9.6, 5, 9.1);
        assertEquals(Polygon.of(3, 10.6, 4.5, 10.6, 5, 9.1, 3, 9.6), drawn());
        Scene last = studio.scene();
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        assertEquals(before, studio.scene());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_Z);
        assertEquals(last, studio.scene());
    }

    @Test
    void aPolygonThatMeetsItselfIsNotClosedAndSaysWhy() {
        Scene before = studio.scene();
        studio.click("tool.polygon");
        clickAt(3, 10.6);
        clickAt(4.5, 10.6);
        clickAt(3, 9.6);
        clickAt(4.5, 9.6);
        studio.keys(KeyEvent.VK_ENTER);
        assertEquals(before, studio.scene());
        String said = OnEventThread.get(() -> ((JLabel) studio.find("status.hint")).getText());
        assertEquals("The outline meets itself: edges 2 and 4", said);
        studio.keys(KeyEvent.VK_ESCAPE);
        assertEquals(before, studio.scene());
        assertEquals(List.of(), steps());
        assertTrue(!OnEventThread.get(() -> canvas().tool().isDrawing()));
    }

    @Test
    void theFirstCornerAndADoubleClickClose() {
        studio.click("tool.polygon");
        clickAt(3, 10.6);
        clickAt(4.5, 10.6);
        clickAt(4.5, 9.6);
        clickAt(3, 10.6);
        assertEquals(Polygon.of(3, 10.6, 4.5, 10.6, 4.5, 9.6), drawn());
        studio.click("tool.ditch");
        clickAt(3, 9.5);
        clickAt(4, 9.5);
        Point last = studio.pixel(4, 9);
        studio.doubleClick(canvas(), last.x, last.y);
        int ditches = studio.scene().ditches().size();
        assertEquals(
                Polygon.of(3, 9.5, 4, 9.5, 4, 9),
                studio.scene().ditches().get(ditches - 1).outline());
        assertEquals(List.of("Draw Obstacle 1", "Draw Ditch 1"), steps());
    }

    @Test
    void rectangleAndCircleAreDraggedAndTheRectangleIsBentTurnedAndScaled() {
        studio.click("tool.rectangle");
        dragFrom(3, 9.5, 4, 10.5);
        assertEquals(Polygon.rectangle(3, 9.5, 4, 10.5), drawn());
        Point edge = studio.pixel(3.5, 9.5);
        studio.doubleClick(canvas(), edge.x, edge.y);
        assertEquals(5, drawn().size());
        studio.keys(KeyEvent.VK_DELETE);
        assertEquals(Polygon.rectangle(3, 9.5, 4, 10.5), drawn());
        double scale = OnEventThread.get(() -> canvas().view().scale());
        Point knob = studio.pixel(3.5, 10.5);
        knob.y -= 35;
        Point right = studio.pixel(3.5, 10);
        right.x += (int) Math.round(0.5 * scale) + 35;
        studio.drag(canvas(), knob, right);
        assertEquals(1, Math.abs(drawn().signedArea()), 1e-3, () -> steps() + " " + drawn());
        assertEquals(3.5, drawn().centroid().x(), 1e-3);
        Point corner = studio.pixel(4, 10.5);
        corner.translate(15, -15);
        studio.drag(canvas(), corner, new Point(corner.x + (int) Math.round(scale), corner.y));
        assertEquals(2, drawn().bounds().width(), 0.06);
        assertEquals(
                List.of(
                        "Draw Obstacle 1",
                        "Add a corner to Obstacle 1",
                        "Take a corner from Obstacle 1",
                        "Turn Obstacle 1",
                        "Scale Obstacle 1"),
                steps());
        studio.click("tool.circle");
        dragFrom(4, 8, 4.5, 8);
        assertEquals(24, drawn().size());
        assertEquals(1, drawn().bounds().width(), 1e-3);
    }

    @Test
    void aCornerSnapsToTheCornerOfAnotherThingAndAltTurnsThatOff() {
        studio.click("tool.rectangle");
        dragFrom(3, 9.5, 4, 10.5);
        studio.click("tool.rectangle");
        Point near = studio.pixel(4, 9.5);
        near.translate(4, 3);
        studio.drag(canvas(), near, studio.pixel(5, 9));
        assertEquals(Polygon.rectangle(4, 9, 5, 9.5), drawn());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        studio.click("tool.rectangle");
        studio.hold(KeyEvent.VK_ALT, () -> studio.drag(canvas(), near, studio.pixel(5, 9)));
        assertNotEquals(Polygon.rectangle(4, 9, 5, 9.5), drawn());
        assertTrue(drawn().bounds().minX() > 4.01);
    }

    @Test
    void aNewJourneyAndANewActorAreDrawnAndPlanned() {
        studio.click("tool.journey");
        clickAt(2, 1.5);
        clickAt(3, 1.5);
        Journey journey = (Journey) studio.scene().task("journey-1").orElseThrow();
        assertEquals(Place.of(2, 1.5), journey.start());
        assertEquals(Place.of(3, 1.5), journey.goal());
        assertTrue(studio.awaitPlan().run().orElseThrow().outcome().isFound());
        studio.click("tool.actor");
        dragFrom(2, 2, 3, 2);
        assertEquals("actor-1", ((Journey) studio.scene().task("journey-2").orElseThrow()).actor());
        assertTrue(studio.awaitPlan().run().orElseThrow().outcome().isFound());
        assertEquals(List.of("Draw Journey 1", "Draw Actor 1"), steps());
    }
}
