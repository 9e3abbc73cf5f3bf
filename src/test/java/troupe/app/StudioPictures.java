package troupe.app;

import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;
import troupe.app.solid.SolidMode;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Makes the pictures of the window for the guide, each from a studio opened on its scene. Needs a display. */
public final class StudioPictures implements AutoCloseable {
    private static final Dimension SIZE = new Dimension(1280, 800);

    private final Path folder;
    private final Path scratch;
    private final StudioFixture studio;

    private StudioPictures(Path folder, String scene, Map<String, String> settings) throws Exception {
        this.folder = folder;
        this.scratch = Files.createTempDirectory("troupe-pictures");
        Path from = Path.of("scenes/" + scene + ".xml");
        Path file = Files.copy(from, scratch.resolve(from.getFileName()));
        this.studio = new StudioFixture(scratch, file, settings);
        OnEventThread.run(() -> {
            studio.window().frame().setSize(SIZE);
            studio.window().wantOutline(true);
            studio.window().frame().validate();
        });
    }

    /** Writes the pictures of the window into a folder. */
    public static void write(Path folder) throws Exception {
        try (StudioPictures p = new StudioPictures(folder, "unified/courtyard", Map.of("solid", "inset"))) {
            p.journey();
        }
        try (StudioPictures p = new StudioPictures(folder, "unified/courtyard", Map.of("theme", "dark"))) {
            p.dark();
        }
        try (StudioPictures p = new StudioPictures(folder, "unified/courtyard", Map.of("language", "zh-TW"))) {
            p.at(0.4);
            p.select("crate");
            p.shoot("studio-chinese");
        }
        try (StudioPictures p = new StudioPictures(folder, "risk/plaza", Map.of())) {
            p.encounter();
        }
        try (StudioPictures p = new StudioPictures(folder, "unified/walk", Map.of("solid", "inset"))) {
            Scene crowd = SceneXml.read(Path.of("scenes/crowd/fork.xml")).scene();
            OnEventThread.run(() -> p.studio.session().document().open(crowd, Optional.empty()));
            p.crowd();
        }
    }

    private void journey() throws IOException {
        at(0.69);
        shoot("studio-light");
        select("crate");
        at(0);
        shoot("studio-edit");
        OnEventThread.run(() -> studio.session().selection().set(List.of()));
        at(0.69);
        OnEventThread.run(() -> studio.window().wantSolid(SolidMode.BESIDE));
        await("the view in three dimensions is painted");
        shoot("studio-solid");
        OnEventThread.run(() -> studio.window().wantSolid(SolidMode.HIDDEN));
        perform("keep");
        Scene scene = studio.scene();
        OnEventThread.run(() -> studio.session()
                .document()
                .commit("Raise", scene.with(raised(scene.obstacle("low-wall").orElseThrow(), 1.6))));
        studio.awaitPlan();
        at(0.5);
        dialog("compare", "studio-compare");
        perform("nocompare");
        dialog("export", "studio-export");
        OnEventThread.run(() -> studio.session()
                .document()
                .commit("Raise", scene.with(fixed(scene.obstacle("crate").orElseThrow()))));
        Await.until("the way is shut", () -> studio.shows("fix.movable"));
        settle();
        shoot("studio-blocked");
        OnEventThread.run(() -> studio.window().pages().showStart());
        Await.until("the examples are shown", () -> studio.shows("example.crowd.fork"));
        await("the pictures of the examples");
        shoot("studio-start");
    }

    private static Obstacle raised(Obstacle o, double height) {
        return new Obstacle(o.id(), o.label(), o.outline(), o.offset(), height, o.movable(), o.mass(), o.colour());
    }

    private static Obstacle fixed(Obstacle o) {
        return new Obstacle(o.id(), o.label(), o.outline(), o.offset(), 3, false, o.mass(), o.colour());
    }

    private void dark() throws IOException {
        show("potential", "skeleton");
        at(0.35);
        shoot("studio-dark");
    }

    private void encounter() throws IOException {
        awaitEnd();
        show("probability", "plan-before", "expected-path");
        at(0.4);
        shoot("studio-encounter");
    }

    private void crowd() throws IOException {
        awaitEnd();
        show("trails", "density");
        at(0.4);
        shoot("studio-crowd");
    }

    private void awaitEnd() {
        Await.until("the simulation has ended", () -> studio.session()
                .run()
                .filter(r -> r.scene().equals(studio.session().document().scene()))
                .filter(r -> !r.outcome().isRunning())
                .isPresent());
    }

    private void perform(String command) {
        OnEventThread.run(() -> studio.window().commands().get(command).perform());
    }

    private void select(String id) {
        OnEventThread.run(() -> studio.session().selection().set(List.of(id)));
    }

    private void show(String... keys) {
        OnEventThread.run(
                () -> Stream.of(keys).forEach(key -> studio.session().overlays().show(key, true)));
        settle();
    }

    /** Shows the run at a share of its time. */
    private void at(double share) {
        OnEventThread.run(() -> {
            double end = studio.session().run().orElseThrow().frames().duration();
            studio.session().playback().seek(share * end);
        });
        settle();
    }

    /** Waits until what the background threads make has been taken and painted: two looks apart must be equal. */
    private void settle() {
        await("nothing changes any more");
    }

    private void await(String what) {
        BufferedImage[] last = {null};
        int[] same = {0};
        Await.until(what, () -> {
            BufferedImage now = image(studio.window().frame().getContentPane());
            boolean equal = last[0] != null
                    && last[0].getWidth() == now.getWidth()
                    && StudioFixture.difference(last[0], now) == 0;
            same[0] = equal ? same[0] + 1 : 0;
            last[0] = now;
            return same[0] >= 12;
        });
    }

    private void dialog(String command, String name) throws IOException {
        SwingUtilities.invokeLater(() -> studio.window().commands().get(command).perform());
        Await.until("the dialog " + command, () -> owned().isPresent());
        settle();
        BufferedImage whole = OnEventThread.get(() -> {
            BufferedImage under = image(studio.window().frame().getRootPane());
            Window dialog = owned().orElseThrow();
            Container content = ((javax.swing.JDialog) dialog).getContentPane();
            Graphics2D g = under.createGraphics();
            BufferedImage over = image(content);
            int x = (under.getWidth() - over.getWidth()) / 2;
            int y = (under.getHeight() - over.getHeight()) / 2;
            g.setColor(new java.awt.Color(0, 0, 0, 70));
            g.fillRect(0, 0, under.getWidth(), under.getHeight());
            g.drawImage(over, x, y, null);
            g.dispose();
            dialog.dispose();
            return under;
        });
        write(name, whole);
    }

    private Optional<Window> owned() {
        return Stream.of(studio.window().frame().getOwnedWindows())
                .filter(w -> w.isShowing() && w instanceof javax.swing.JDialog)
                .findFirst();
    }

    private static BufferedImage image(Container part) {
        BufferedImage image = new BufferedImage(part.getWidth(), part.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        part.printAll(g);
        g.dispose();
        return image;
    }

    private void shoot(String name) throws IOException {
        write(name, OnEventThread.get(() -> image(studio.window().frame().getRootPane())));
    }

    private void write(String name, BufferedImage image) throws IOException {
        ImageIO.write(image, "png", folder.resolve(name + ".png").toFile());
        System.out.println(folder.resolve(name + ".png"));
    }

    @Override
    public void close() throws IOException {
        studio.close();
        try (Stream<Path> files = Files.walk(scratch)) {
            for (Path file : files.sorted(java.util.Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
