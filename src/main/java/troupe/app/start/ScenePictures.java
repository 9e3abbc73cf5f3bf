package troupe.app.start;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import troupe.app.document.EventThread;
import troupe.app.session.SceneFiles;
import troupe.paint.Theme;
import troupe.paint.picture.Picture;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/**
 * Makes small pictures of scene files, one after the other on a background thread of low priority, and keeps them.
 * Belongs to the event thread.
 */
public final class ScenePictures implements AutoCloseable {

    /**
     * What a picture is of.
     *
     * @param width the most pixels it may be wide before {@code density}
     * @param height the most pixels it may be high before {@code density}
     * @param density how many pixels of the screen there are to a pixel, from 1 to 4
     */
    public record Wanted(Path file, Theme theme, int width, int height, double density) {}

    /**
     * A scene file, read and painted.
     *
     * @param title the title of the scene, or the name of the file
     * @param image the picture, empty if the file cannot be read
     */
    public record Made(String title, Optional<BufferedImage> image) {}

    private static final int FINER = 2;
    private static final double EDGES = 34;
    private static final double SHOWN = 28;

    private final SceneFiles files;
    private final Executor eventThread;
    private final Map<Wanted, Made> kept = new HashMap<>();
    private final ExecutorService background = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "pictures");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        return thread;
    });

    /** Makes an empty collection. */
    public ScenePictures(SceneFiles files, Executor eventThread) {
        this.files = files;
        this.eventThread = eventThread;
    }

    /** Gives a picture: at once if it is kept, else when it is made. */
    public void request(Wanted wanted, Consumer<Made> taker) {
        EventThread.require();
        Made made = kept.get(wanted);
        if (made != null) {
            taker.accept(made);
            return;
        }
        inBackground(() -> {
            Made fresh = make(wanted);
            eventThread.execute(() -> {
                kept.put(wanted, fresh);
                taker.accept(fresh);
            });
        });
    }

    /** Runs something on the thread of the pictures, after those asked for before. */
    public void inBackground(Runnable task) {
        if (!background.isShutdown()) {
            background.execute(task);
        }
    }

    private Made make(Wanted wanted) {
        String name = wanted.file().getFileName().toString();
        try {
            Scene scene = files.read(wanted.file());
            return new Made(scene.title().isEmpty() ? name : scene.title(), Optional.of(paint(scene, wanted)));
        } catch (SceneException | IOException e) {
            return new Made(name, Optional.empty());
        }
    }

    /**
     * Returns the largest picture of a scene that fits, without its scale: laid out larger and drawn smaller, so
     * that lines and signs stay fine. Runs on any thread.
     */
    public static BufferedImage paint(Scene scene, Wanted wanted) {
        Picture picture = Picture.of(scene).with(wanted.theme());
        double aspect = scene.world().depth() / scene.world().width();
        double inner =
                Math.min(FINER * wanted.width() - EDGES, (FINER * wanted.height() - EDGES) / Math.max(1e-3, aspect));
        int width = (int) Math.max(Picture.MIN_WIDTH, inner + EDGES);
        BufferedImage large = picture.image(width, wanted.density());
        int height = (int) Math.min(large.getHeight(), (inner * aspect + SHOWN) * wanted.density());
        BufferedImage small =
                new BufferedImage(large.getWidth() / FINER, Math.max(1, height / FINER), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = small.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.drawImage(large, 0, 0, large.getWidth() / FINER, large.getHeight() / FINER, null);
        g.dispose();
        return small;
    }

    @Override
    public void close() {
        background.shutdownNow();
    }
}
