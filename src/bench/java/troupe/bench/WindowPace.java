package troupe.bench;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.RepaintManager;
import troupe.app.Studio;
import troupe.scene.xml.SceneXml;

/**
 * Measures the window while a simulation is played in it: {@code WindowPace SCENE SECONDS [drag|move X0 Y0 X1 Y1]}.
 * Opens the studio with the scene, or with a town of so many agents where the scene is a number, plays for so many
 * seconds, and, if asked, moves the mouse over the canvas meanwhile, held down or not, to and fro between two pixels. Prints how often the canvas was painted in a second, and how long the events of the
 * event thread took, on the clock and in the thread's own time. With a fifth word more, {@code shot FILE}, it writes
 * the window as a picture at the end.
 */
public final class WindowPace {
    private static final int MOVE_MS = 15;
    private static final int WARM_S = 4;

    private final List<long[]> events = new ArrayList<>();
    private final List<long[]> frames = new ArrayList<>();
    private int painted;

    private WindowPace() {}

    /** Opens the window, plays, prints, and ends the program. */
    public static void main(String[] words) throws Exception {
        new WindowPace().measure(List.of(words));
        System.exit(0);
    }

    private void measure(List<String> words) throws Exception {
        // what is simulated is kept for the person, who has nothing to do with this
        System.setProperty("user.home", Files.createTempDirectory("pace").toString());
        Studio.open(Optional.of(scene(words.get(0))));
        int seconds = Integer.parseInt(words.get(1));
        EventQueue.invokeAndWait(() -> {
            Toolkit.getDefaultToolkit().getSystemEventQueue().push(new Timed());
        });
        Component canvas = named("canvas");
        EventQueue.invokeAndWait(() -> RepaintManager.setCurrentManager(new Counting(canvas)));
        rest(WARM_S);
        EventQueue.invokeAndWait(() -> ((AbstractButton) named("transport.play")).doClick());
        rest(1);
        EventQueue.invokeAndWait(() -> {
            events.clear();
            frames.clear();
            painted = 0;
        });
        long begin = System.nanoTime();
        int at = Math.max(words.indexOf("drag"), words.indexOf("move"));
        if (at > 0) {
            move(canvas, words.get(at).equals("drag"), words.subList(at + 1, at + 5), seconds);
        } else {
            rest(seconds);
        }
        double took = (System.nanoTime() - begin) / 1e9;
        EventQueue.invokeAndWait(() -> print(words.get(0), took));
        int shot = words.indexOf("shot");
        if (shot > 0) {
            shoot(new File(words.get(shot + 1)));
        }
    }

    private static void rest(int seconds) {
        LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(seconds));
    }

    private static Path scene(String word) throws Exception {
        if (!word.matches("\\d+")) {
            return Path.of(word);
        }
        Path file = Files.createTempFile("crowd", ".xml");
        file.toFile().deleteOnExit();
        SceneXml.write(CrowdBench.town(Integer.parseInt(word)), file);
        return file;
    }

    /** Goes from one pixel of the canvas to the other and back, a round in four seconds. */
    private static void move(Component canvas, boolean held, List<String> ends, int seconds) throws Exception {
        int[] p = ends.stream().mapToInt(Integer::parseInt).toArray();
        int moved = held ? MouseEvent.MOUSE_DRAGGED : MouseEvent.MOUSE_MOVED;
        if (held) {
            mouse(canvas, MouseEvent.MOUSE_PRESSED, p[0], p[1]);
        }
        int moves = seconds * 1000 / MOVE_MS;
        for (int k = 0; k < moves; k++) {
            double share = (1 - Math.cos(k * MOVE_MS / 4000.0 * 2 * Math.PI)) / 2;
            mouse(canvas, moved, (int) (p[0] + share * (p[2] - p[0])), (int) (p[1] + share * (p[3] - p[1])));
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(MOVE_MS));
        }
        if (held) {
            mouse(canvas, MouseEvent.MOUSE_RELEASED, p[0], p[1]);
        }
    }

    private static void mouse(Component canvas, int id, int x, int y) {
        boolean moves = id == MouseEvent.MOUSE_MOVED;
        int held = moves || id == MouseEvent.MOUSE_RELEASED ? 0 : InputEvent.BUTTON1_DOWN_MASK;
        int button = moves || id == MouseEvent.MOUSE_DRAGGED ? MouseEvent.NOBUTTON : MouseEvent.BUTTON1;
        MouseEvent event = new MouseEvent(canvas, id, System.currentTimeMillis(), held, x, y, 1, false, button);
        Toolkit.getDefaultToolkit().getSystemEventQueue().postEvent(event);
    }

    private static Component named(String name) {
        for (Frame frame : Frame.getFrames()) {
            Optional<Component> found = named(frame, name);
            if (found.isPresent()) {
                return found.get();
            }
        }
        throw new IllegalStateException("no component " + name + " in the window");
    }

    private static Optional<Component> named(Container in, String name) {
        for (Component part : in.getComponents()) {
            Optional<Component> found = name.equals(part.getName())
                    ? Optional.of(part)
                    : part instanceof Container inner ? named(inner, name) : Optional.empty();
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    private void print(String scene, double seconds) {
        long[] clock = events.stream().mapToLong(e -> e[0]).sorted().toArray();
        long[] own = events.stream().mapToLong(e -> e[1]).sorted().toArray();
        long all = 0;
        for (long nanos : own) {
            all += nanos;
        }
        System.out.printf(
                Locale.ROOT,
                "%s: canvas painted %.1f times a second; event thread busy %.0f %% (own time)%n",
                scene,
                painted / seconds,
                100 * all / 1e9 / seconds);
        long[] shown = frames.stream().mapToLong(e -> e[0]).sorted().toArray();
        long[] frame = frames.stream().mapToLong(e -> e[1]).sorted().toArray();
        System.out.printf(
                Locale.ROOT,
                "painting the window: own time ms median %.2f, longest %.2f; clock ms median %.2f%n",
                frame.length == 0 ? 0 : frame[frame.length / 2] / 1e6,
                frame.length == 0 ? 0 : frame[frame.length - 1] / 1e6,
                shown.length == 0 ? 0 : shown[shown.length / 2] / 1e6);
        System.out.printf(
                Locale.ROOT,
                "%d events: own time ms median %.2f, 99 %% %.2f, longest %.2f; clock ms 99 %% %.2f, longest %.2f%n",
                own.length,
                own[own.length / 2] / 1e6,
                own[own.length * 99 / 100] / 1e6,
                own[own.length - 1] / 1e6,
                clock[clock.length * 99 / 100] / 1e6,
                clock[clock.length - 1] / 1e6);
    }

    private static void shoot(File file) throws Exception {
        Frame frame = Frame.getFrames()[0];
        BufferedImage image = new BufferedImage(frame.getWidth(), frame.getHeight(), BufferedImage.TYPE_INT_RGB);
        EventQueue.invokeAndWait(() -> frame.paint(image.getGraphics()));
        ImageIO.write(image, "png", file);
    }

    /** Notes how long each event takes, on the clock and in the thread's own time. */
    private final class Timed extends EventQueue {
        private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

        @Override
        protected void dispatchEvent(AWTEvent event) {
            int before = painted;
            long clock = System.nanoTime();
            long own = threads.getCurrentThreadCpuTime();
            super.dispatchEvent(event);
            long[] took = {System.nanoTime() - clock, threads.getCurrentThreadCpuTime() - own};
            events.add(took);
            if (painted > before) {
                frames.add(took);
            }
        }
    }

    /** Counts how often the canvas is painted. */
    private final class Counting extends RepaintManager {
        private final Component canvas;

        private Counting(Component canvas) {
            this.canvas = canvas;
        }

        @Override
        public void paintDirtyRegions() {
            painted += isCompletelyDirty((JComponent) canvas)
                            || !getDirtyRegion((JComponent) canvas).isEmpty()
                    ? 1
                    : 0;
            super.paintDirtyRegions();
        }
    }
}
