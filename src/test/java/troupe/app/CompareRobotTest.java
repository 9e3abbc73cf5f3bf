package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import troupe.run.Run;
import troupe.run.file.RunFile;

/** Keeps a run, changes the scene, and compares. */
class CompareRobotTest extends RobotTest {
    private BufferedImage canvas() {
        var canvas = studio.window().canvas();
        BufferedImage image = new BufferedImage(canvas.getWidth(), canvas.getHeight(), BufferedImage.TYPE_INT_RGB);
        canvas.paint(image.createGraphics());
        return image;
    }

    @Test
    void aKeptRunStaysAsAGhostAndItsReportBesideTheNewOne() {
        studio.awaitPlan();
        perform("keep");
        studio.drag(studio.window().canvas(), studio.pixel(8.125, 7.6), studio.pixel(5.5, 9.5));
        studio.awaitPlan();
        perform("compare");
        Await.until("the table", () -> studio.shows("compare.table"));
        JTable table = (JTable) studio.find("compare.table");
        Await.until("a difference is marked", () -> {
            for (int row = 0; row < table.getRowCount(); row++) {
                if (table.getValueAt(row, 0).equals("energy")) {
                    return !table.getValueAt(row, 3).equals("");
                }
            }
            return false;
        });
        BufferedImage with = OnEventThread.get(this::canvas);
        perform("nocompare");
        Await.until("the table is gone", () -> !studio.shows("compare.table"));
        BufferedImage without = OnEventThread.get(this::canvas);
        assertTrue(StudioFixture.difference(with, without) > 0.001);
    }

    @Test
    void aSavedRunIsPlayedAsItWasSavedUntilTheNextPlan() throws Exception {
        Run run = studio.awaitPlan().run().orElseThrow();
        Path file = folder.resolve("a.run");
        RunFile.write(run, file);
        Run read = RunFile.read(file);
        OnEventThread.run(() -> studio.session().show(read));
        assertEquals(read, OnEventThread.get(() -> studio.session().run().orElseThrow()));
        assertFalse(OnEventThread.get(() -> studio.session().isLive()));
        assertFalse(
                OnEventThread.get(() -> studio.window().commands().get("live").isOn()));
        studio.click("transport.play");
        Await.until("it plays", () -> studio.session().playback().time() > 0.2);
        perform("plannow");
        Await.until("planned anew", () -> studio.session().run().orElseThrow() != read);
    }
}
