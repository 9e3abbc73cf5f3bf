package troupe.app.solid;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import troupe.paint.Theme;
import troupe.paint.solid.Camera;
import troupe.paint.solid.SolidPainter;
import troupe.run.Run;
import troupe.scene.Scene;

/**
 * Makes pictures in three dimensions on a background thread; of several wishes only the newest is met. While only what
 * is shown moves, it rests between the pictures, so that large crowds are left to what simulates and paints them.
 */
final class SolidPictures implements AutoCloseable {
    /** How many times as long as a picture took the rest after it is. */
    private static final int REST = 3;

    private static final long LEAST_NANOS = TimeUnit.MILLISECONDS.toNanos(8);
    private static final long MOST_REST_NANOS = TimeUnit.MILLISECONDS.toNanos(200);

    /** Everything that a picture depends on. */
    record Wish(
            Scene scene,
            Optional<Run> run,
            Theme theme,
            double time,
            double elevation,
            Set<String> marked,
            Camera camera,
            Frame frame) {}

    /** The size of a picture: pixels as laid out, how many times as large it is drawn, and whether in a hurry. */
    record Frame(int width, int height, double density, boolean draft, Color background) {}

    /** A picture and the wish that it meets. */
    record Made(Wish wish, BufferedImage image) {}

    private final Executor eventThread;
    private final Consumer<Made> taker;
    private final ExecutorService worker = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "solid");
        thread.setDaemon(true);
        return thread;
    });
    private volatile Wish newest;
    private SolidPainter painter;
    private Wish painted;

    /** Makes the maker; {@code taker} gets the pictures on the event thread. */
    SolidPictures(Executor eventThread, Consumer<Made> taker) {
        this.eventThread = eventThread;
        this.taker = taker;
    }

    /** Wishes for a picture; those asked for before and not begun are dropped. */
    void wish(Wish wish) {
        newest = wish;
        worker.execute(() -> {
            if (newest == wish) {
                boolean moves = painted != null
                        && painted.camera().equals(wish.camera())
                        && painted.scene() == wish.scene()
                        && painted.time() != wish.time();
                long begin = System.nanoTime();
                BufferedImage image = make(wish);
                eventThread.execute(() -> taker.accept(new Made(wish, image)));
                long took = System.nanoTime() - begin;
                if (moves && took > LEAST_NANOS) {
                    LockSupport.parkNanos(Math.min(REST * took, MOST_REST_NANOS));
                }
            }
        });
    }

    private BufferedImage make(Wish wish) {
        boolean same = painted != null
                && painted.scene() == wish.scene()
                && painted.run().orElse(null) == wish.run().orElse(null)
                && painted.theme() == wish.theme();
        if (!same) {
            painter = new SolidPainter(wish.scene(), wish.run(), wish.theme());
        }
        painted = wish;
        Frame frame = wish.frame();
        return painter.upTo(wish.elevation())
                .marking(wish.marked())
                .drafting(frame.draft())
                .image(wish.camera(), frame.width(), frame.height(), frame.density(), wish.time(), frame.background());
    }

    @Override
    public void close() {
        worker.shutdown();
    }
}
