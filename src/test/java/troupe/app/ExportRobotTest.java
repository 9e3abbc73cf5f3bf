package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import troupe.exchange.Formats;
import troupe.exchange.format.Exporter;

/** Exports the run from the window. */
class ExportRobotTest extends RobotTest {
    @Override
    void begin() throws Exception {
        super.begin();
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_E);
        Await.until("the dialog", () -> studio.shows("export.formats"));
    }

    private void choose(String format) {
        Exporter exporter = Formats.exporter(format);
        OnEventThread.run(() -> ((JList<?>) studio.find("export.formats")).setSelectedValue(exporter, true));
    }

    private String description(String name) {
        return studio.find(name).getAccessibleContext().getAccessibleDescription();
    }

    private String message() {
        return ((JLabel) studio.find("export.message")).getText();
    }

    @Test
    void aGifInThreeDimensionsIsWrittenBesideTheScene() throws Exception {
        choose("gif");
        studio.click("export.view.solid");
        studio.click("export.width");
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        studio.type("160");
        studio.keys(KeyEvent.VK_ENTER);
        Path target = Path.of(OnEventThread.get(() -> ((JTextField) studio.find("export.target")).getText()));
        assertEquals(folder.resolve("courtyard-to-the-fountain.gif"), target);
        studio.click("export.write");
        Await.until("written", () -> message().startsWith("Written to"));
        assertEquals("GIF", new String(Files.readAllBytes(target), 0, 3, StandardCharsets.US_ASCII));
        studio.click("export.close");
        Await.until("closed", () -> !studio.shows("export.formats"));
    }

    @Test
    void aTableIsPreviewedAndACancelledAnimationLeavesNothing() throws Exception {
        choose("csv");
        Await.until("the first lines", () -> String.valueOf(description("export.preview"))
                .startsWith("frame,time"));
        choose("pngs");
        studio.click("export.write");
        studio.keys(KeyEvent.VK_ESCAPE);
        Await.until("cancelled", () -> message().startsWith("Cancelled"));
        try (Stream<Path> files = Files.list(folder)) {
            assertTrue(files.noneMatch(f -> f.toString().endsWith(".png")));
        }
        studio.keys(KeyEvent.VK_ESCAPE);
        Await.until("closed", () -> !studio.shows("export.formats"));
    }
}
