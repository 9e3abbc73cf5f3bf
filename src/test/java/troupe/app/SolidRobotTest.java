package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import troupe.app.canvas.Canvas;
import troupe.app.solid.Eye;
import troupe.app.solid.SolidView;
import troupe.scene.World;

/** Works the view in three dimensions with mouse and keys. */
class SolidRobotTest extends RobotTest {
    @Override
    void begin() throws Exception {
        super.begin();
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_1);
        Await.until("the card", () -> studio.find("solid").isShowing());
    }

    private SolidView view() {
        return (SolidView) studio.find("solid");
    }

    private Eye eye() {
        return OnEventThread.get(() -> view().eye());
    }

    /** Paints the view; on the event thread. */
    private BufferedImage painted() {
        Component view = view();
        BufferedImage image = new BufferedImage(view.getWidth(), view.getHeight(), BufferedImage.TYPE_INT_RGB);
        view.paint(image.createGraphics());
        return image;
    }

    private BufferedImage awaitPicture() {
        Await.until("a picture with more than a ground", () -> {
            BufferedImage now = painted();
            int[] pixels = now.getRGB(0, 0, now.getWidth(), now.getHeight(), null, 0, now.getWidth());
            return Arrays.stream(pixels).distinct().count() > 60;
        });
        return OnEventThread.get(this::painted);
    }

    @Test
    void theCardNeverCoversTheSceneAndTurnsWithTheMouse() {
        Canvas canvas = studio.window().canvas();
        World world = studio.scene().world();
        Point corner = studio.pixel(world.width(), world.depth());
        Rectangle card = OnEventThread.get(
                () -> SwingUtilities.convertRectangle(view().getParent(), view().getBounds(), canvas));
        assertTrue(corner.x <= card.x || corner.y >= card.y + card.height, corner + " under " + card);
        BufferedImage before = awaitPicture();
        Eye first = eye();
        studio.drag(view(), new Point(60, 90), new Point(140, 70));
        assertNotEquals(first.angle().azimuthRad(), eye().angle().azimuthRad());
        assertNotEquals(first.angle().elevationRad(), eye().angle().elevationRad());
        Await.until("the picture is another", () -> StudioFixture.difference(before, painted()) > 0.1);
        studio.moveTo(view(), 100, 90);
        studio.wheel(-2);
        assertTrue(eye().zoom() > 1.2);
        studio.keys(KeyEvent.VK_HOME);
        assertEquals(Eye.DEFAULT, eye());
    }

    @Test
    void itStandsBesideThePlanOrAloneOrAway() {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_2);
        Await.until("beside", () -> view().isShowing() && view().getWidth() > 240);
        assertTrue(studio.window().canvas().isShowing());
        awaitPicture();
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_3);
        Await.until(
                "alone", () -> view().isShowing() && !studio.window().canvas().isShowing());
        awaitPicture();
        assertEquals("alone", studio.settings().get("solid"));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_1);
        Await.until("in the corner", () -> view().isShowing() && view().getWidth() < 240);
        studio.click("solid.hide");
        Await.until("hidden", () -> !studio.shows("solid"));
        assertFalse(OnEventThread.get(
                () -> studio.window().commands().get("solid.inset").isOn()));
        assertEquals("hidden", studio.settings().get("solid"));
    }

    @Test
    void itFollowsTheRun() {
        BufferedImage before = awaitPicture();
        OnEventThread.run(() ->
                studio.session().playback().seek(studio.session().playback().duration() * 0.8));
        Await.until("whoever moves is elsewhere", () -> StudioFixture.difference(before, painted()) > 0.001);
    }
}
