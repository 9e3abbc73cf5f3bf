package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JMenu;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.Test;
import troupe.app.document.SceneDocument;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Begins on the start page, with new scenes, with files dropped and opened before, as a person would. */
class StartPageRobotTest extends RobotTest {
    private SceneDocument document() {
        return studio.session().document();
    }

    private boolean showsExample(String name) {
        return studio.shows(name)
                && studio.find(name) instanceof javax.swing.JButton card
                && card.getAccessibleContext().getAccessibleDescription() != null;
    }

    private static Transferable files(Path file) {
        return new Transferable() {
            @Override
            public DataFlavor[] getTransferDataFlavors() {
                return new DataFlavor[] {DataFlavor.javaFileListFlavor};
            }

            @Override
            public boolean isDataFlavorSupported(DataFlavor flavor) {
                return flavor.equals(DataFlavor.javaFileListFlavor);
            }

            @Override
            public Object getTransferData(DataFlavor flavor) {
                return List.of(file.toFile());
            }
        };
    }

    private void drop(Path file) {
        javax.swing.SwingUtilities.invokeLater(() -> {
            javax.swing.JFrame frame = studio.window().frame();
            frame.getTransferHandler().importData(new TransferSupport(frame.getRootPane(), files(file)));
        });
    }

    private void moveTheCrate() {
        studio.drag(studio.window().canvas(), studio.pixel(8.125, 7.6), studio.pixel(5.5, 9.5));
        Await.until("edited", () -> document().isUnsaved());
    }

    private Path another() throws Exception {
        return Files.copy(Path.of("scenes/unified/stairs.xml"), folder.resolve("stairs.xml"));
    }

    @Test
    void anExampleIsChosenByItsPictureAndOpensAsANewScene() throws Exception {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_HOME);
        Await.until("the examples are shown", () -> showsExample("example.unified.stairs"));
        Await.until("the first has the picture of its scene", () -> {
            Component card = studio.find("example.unified.courtyard");
            java.awt.image.BufferedImage image = new java.awt.image.BufferedImage(
                    card.getWidth(), card.getHeight(), java.awt.image.BufferedImage.TYPE_INT_RGB);
            card.paint(image.getGraphics());
            return differentColours(image) > 20;
        });
        studio.click("example.unified.stairs");
        Scene stairs = SceneXml.read(Path.of("scenes/unified/stairs.xml")).scene();
        Await.until("the example is open", () -> document().scene().equals(stairs));
        assertEquals(Optional.empty(), OnEventThread.get(() -> document().file()));
        assertFalse(OnEventThread.get(() -> document().isUnsaved()));
        Await.until("the scene is shown", () -> studio.window().canvas().isShowing());
        assertTrue(studio.awaitPlan().run().orElseThrow().outcome().isFound());
    }

    private static long differentColours(java.awt.image.BufferedImage image) {
        return java.util.Arrays.stream(
                        image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .distinct()
                .count();
    }

    @Test
    void escapeLeavesTheStartPageAndTheSceneStays() {
        Scene before = studio.scene();
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_HOME);
        Await.until("the examples are shown", () -> showsExample("example.unified.courtyard"));
        Await.until("something on the page has the focus", () -> {
            Component focus = studio.window().frame().getFocusOwner();
            return focus != null && javax.swing.SwingUtilities.isDescendingFrom(focus, studio.find("start"));
        });
        studio.keys(KeyEvent.VK_ESCAPE);
        Await.until("the canvas has the focus", () -> studio.window().canvas().isFocusOwner());
        assertEquals(before, studio.scene());
    }

    @Test
    void aNewSceneHasAPlanAndIsEditedAtOnce() {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_N);
        Await.until("the sizes are offered", () -> studio.shows("new.room"));
        studio.click("new.room");
        Await.until("the scene is new", () -> document().scene().world().width() == 6);
        assertTrue(studio.awaitPlan().run().orElseThrow().outcome().isFound());
        studio.drag(studio.window().canvas(), studio.pixel(1, 2.5), studio.pixel(1, 4));
        Await.until("edited", () -> document().isUnsaved());
        Await.until(
                "the title says so", () -> studio.window().frame().getTitle().equals("Untitled — edited – Troupe"));
    }

    @Test
    void aDroppedFileIsOpenedAndRemembered() throws Exception {
        Path file = another();
        drop(file);
        Await.until("opened", () -> document().file().equals(Optional.of(file)));
        Await.until(
                "the title is the file's",
                () -> studio.window().frame().getTitle().equals("stairs.xml – Troupe"));
        OnEventThread.run(() -> {
            JMenu recent = (JMenu) ((JMenu) studio.find("menu.file")).getMenuComponent(3);
            assertEquals("menu.recent", recent.getName());
            recent.getMenuListeners()[0].menuSelected(null);
            assertEquals("stairs.xml", recent.getItem(0).getText());
        });
    }

    @Test
    void aMapIsImportedAsAStepThatIsTakenBack() throws Exception {
        Scene before = studio.scene();
        Path map = folder.resolve("arena.map");
        Files.writeString(map, "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT, KeyEvent.VK_I);
        Await.until("a file is asked for", () -> chooser().isPresent());
        JFileChooser chooser = OnEventThread.get(() -> chooser().orElseThrow());
        OnEventThread.run(() -> {
            assertTrue(chooser.getFileFilter().accept(map.toFile()));
            assertFalse(chooser.getFileFilter().accept(studio.file().toFile()));
            chooser.setSelectedFile(map.toFile());
        });
        studio.keys(KeyEvent.VK_ENTER);
        Await.until("imported", () -> document().scene().world().width() == 4);
        assertEquals(
                Optional.of(studio.file()), OnEventThread.get(() -> document().file()));
        Await.until("the chooser is gone", () -> chooser().isEmpty());
        studio.click(studio.window().canvas(), 3, studio.window().canvas().getHeight() - 60);
        Await.until("the canvas has the focus", () -> studio.window().canvas().isFocusOwner());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        Await.until("taken back", () -> document().scene().equals(before));
    }

    private Optional<JFileChooser> chooser() {
        return Stream.of(studio.window().frame().getOwnedWindows())
                .filter(window -> window instanceof JDialog && window.isShowing())
                .map(window -> ((JDialog) window).getContentPane().getComponent(0))
                .filter(JFileChooser.class::isInstance)
                .map(JFileChooser.class::cast)
                .findFirst();
    }

    @Test
    void unsavedWorkIsNotLostUnasked() throws Exception {
        moveTheCrate();
        Scene edited = studio.scene();
        Path file = another();
        drop(file);
        Await.until("the question is asked", () -> studio.shows("unsaved.cancel"));
        studio.click("unsaved.cancel");
        Await.until("the question is gone", () -> !studio.shows("unsaved.cancel"));
        assertEquals(edited, studio.scene());
        drop(file);
        Await.until("the question is asked again", () -> studio.shows("unsaved.save"));
        studio.click("unsaved.save");
        Await.until("opened", () -> document().file().equals(Optional.of(file)));
        assertEquals(edited, SceneXml.read(studio.file()).scene());
    }

    @Test
    void whatIsDiscardedIsNotSaved() throws Exception {
        Scene before = studio.scene();
        moveTheCrate();
        Path file = another();
        drop(file);
        Await.until("the question is asked", () -> studio.shows("unsaved.discard"));
        studio.click("unsaved.discard");
        Await.until("opened", () -> document().file().equals(Optional.of(file)));
        assertEquals(before, SceneXml.read(studio.file()).scene());
    }
}
