package troupe.app;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import javax.swing.RepaintManager;
import javax.swing.SwingUtilities;
import troupe.app.document.SceneDocument;
import troupe.app.look.Named;
import troupe.app.plan.Plan;
import troupe.app.plan.PlanningSteps;
import troupe.app.session.SceneFiles;
import troupe.app.session.Session;
import troupe.app.settings.StudioSettings;
import troupe.exchange.format.ExchangeException;
import troupe.paint.Viewport;
import troupe.run.Engine;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;

/** A studio on the screen with a copy of a sample scene, and a robot that works it. */
final class StudioFixture implements AutoCloseable {
    private final PaintGuard guard = new PaintGuard();
    private final EventThreadWatch watch = new EventThreadWatch();
    private final AtomicReference<Exception> uncaught = new AtomicReference<>();
    private final Map<String, String> settings = new HashMap<>();
    private final Robot robot;
    private final Path file;
    private final StudioWindow window;

    StudioFixture(Path folder) throws IOException, SceneException, AWTException {
        this(folder, Files.copy(Path.of(Studio.DEFAULT_SCENE), folder.resolve("courtyard.xml")), Map.of());
        click(window.canvas(), window.canvas().getWidth() - 3, window.canvas().getHeight() - 60);
        Await.until("the canvas has the focus", () -> window.canvas().isFocusOwner());
    }

    /** Opens a file with settings; unsaved edits of documents without a file are kept in a folder in {@code folder}. */
    StudioFixture(Path folder, Path scenes, Map<String, String> chosen)
            throws IOException, SceneException, AWTException {
        robot = new Robot();
        Thread.setDefaultUncaughtExceptionHandler((thread, thrown) -> {
            // what a test asks for in vain while it waits is an error, no exception
            if (thrown instanceof Exception exception) {
                uncaught.compareAndSet(null, exception);
            }
        });
        robot.setAutoDelay(12);
        file = scenes;
        Scene scene = SceneXml.read(file).scene();
        settings.put("language", "en");
        settings.put("solid", "hidden");
        settings.put("tour", "true");
        settings.put("recovery", folder.resolve("recovery").toString());
        settings.putAll(chosen);
        window = OnEventThread.get(() -> {
            RepaintManager.setCurrentManager(guard);
            Session session =
                    new Session(new SceneDocument(scene, Optional.of(file)), STEPS, FILES, EventQueue::invokeLater);
            StudioWindow made = new StudioWindow(
                    session, new StudioSettings(settings::getOrDefault, settings::put), EventQueue::invokeLater);
            made.open();
            session.planNow();
            return made;
        });
        Await.until(
                "the window is there",
                () -> window.canvas().isShowing() && window.canvas().getWidth() > 0);
        awaitPlan();
    }

    private static final SceneFiles FILES = new SceneFiles() {
        @Override
        public Scene read(Path from) throws SceneException, IOException {
            assertFalse(EventQueue.isDispatchThread());
            return Studio.FILES.read(from);
        }

        @Override
        public Scene convert(Path from) throws ExchangeException, IOException {
            assertFalse(EventQueue.isDispatchThread());
            return Studio.FILES.convert(from);
        }

        @Override
        public void write(Scene scene, Path to) throws IOException {
            assertFalse(EventQueue.isDispatchThread());
            Studio.FILES.write(scene, to);
        }
    };

    private static final PlanningSteps STEPS = new PlanningSteps() {
        private final PlanningSteps steps = new Studio.Steps();

        @Override
        public List<Problem> check(Scene scene) {
            assertFalse(EventQueue.isDispatchThread());
            return steps.check(scene);
        }

        @Override
        public List<Problem> inspect(Scene scene) {
            assertFalse(EventQueue.isDispatchThread());
            return steps.inspect(scene);
        }

        @Override
        public Engine start(Scene scene, String task) {
            assertFalse(EventQueue.isDispatchThread());
            return steps.start(scene, task);
        }

        @Override
        public List<Overlay> overlays(
                Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
            assertFalse(EventQueue.isDispatchThread());
            return steps.overlays(scene, task, engine, chosen, wanted);
        }
    };

    StudioWindow window() {
        return window;
    }

    Session session() {
        return window.session();
    }

    Path file() {
        return file;
    }

    Map<String, String> settings() {
        return settings;
    }

    /** Returns the scene as it is committed. */
    Scene scene() {
        return OnEventThread.get(() -> session().document().scene());
    }

    /** Waits for the plan of the present version, with its views. */
    Plan awaitPlan() {
        Await.until("a plan of the scene that is shown", () -> session()
                .plan()
                .filter(p -> p.snapshot().version().equals(session().document().version()))
                .filter(p -> p.views().current()
                        || p.snapshot().version().preview() > 0 && !p.overlays().isEmpty())
                .isPresent());
        return OnEventThread.get(() -> session().plan().orElseThrow());
    }

    /** Returns the pixel of the canvas that shows a place in metres. */
    Point pixel(double x, double y) {
        Viewport view = OnEventThread.get(() -> window.canvas().view());
        double scale = OnEventThread.get(() -> window.look().scale());
        return new Point((int) Math.round(view.px(x) * scale), (int) Math.round(view.py(y) * scale));
    }

    private Point onScreen(Component component, int x, int y) {
        Point at = OnEventThread.get(() -> {
            placeAgain(component);
            return component.getLocationOnScreen();
        });
        return new Point(at.x + x, at.y + y);
    }

    void moveTo(Component component, int x, int y) {
        Point at = onScreen(component, x, y);
        robot.mouseMove(at.x, at.y);
        robot.waitForIdle();
    }

    void click(Component component, int x, int y) {
        moveTo(component, x, y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.waitForIdle();
    }

    /** Clicks a component as soon as it is to be seen and has come to rest where it belongs. */
    void click(String name) {
        Component component = find(name);
        Point[] last = {null};
        Await.until(name + " has come to rest", () -> {
            placeAgain(component);
            Point now = component.isShowing() ? component.getLocationOnScreen() : null;
            boolean rests = now != null && now.equals(last[0]);
            last[0] = now;
            return rests;
        });
        click(component, component.getWidth() / 2, component.getHeight() / 2);
    }

    /**
     * Places a dialog again that AWT believes to be in the corner of the screen. Without a window manager it is told
     * so now and then by a notice from before the dialog was placed, and a robot would click beside it.
     */
    private void placeAgain(Component component) {
        Window around = SwingUtilities.getWindowAncestor(component);
        if (around instanceof Dialog && around.getLocation().equals(new Point())) {
            around.setLocationRelativeTo(window.frame());
        }
    }

    void doubleClick(Component component, int x, int y) {
        moveTo(component, x, y);
        for (int i = 0; i < 2; i++) {
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        }
        robot.waitForIdle();
    }

    /** Does something while a key is down. */
    void hold(int key, Runnable action) {
        robot.keyPress(key);
        try {
            action.run();
        } finally {
            robot.keyRelease(key);
            robot.waitForIdle();
        }
    }

    /** Presses at one pixel and moves to another in steps; the button stays down. */
    void pressAndMove(Component component, Point from, Point to) {
        moveTo(component, from.x, from.y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        int steps = 8;
        for (int i = 1; i <= steps; i++) {
            moveTo(component, from.x + (to.x - from.x) * i / steps, from.y + (to.y - from.y) * i / steps);
        }
    }

    void release() {
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        robot.waitForIdle();
    }

    void drag(Component component, Point from, Point to) {
        pressAndMove(component, from, to);
        release();
    }

    void wheel(int notches) {
        robot.mouseWheel(notches);
        robot.waitForIdle();
    }

    /** Presses keys together and lets them go. */
    void keys(int... codes) {
        for (int code : codes) {
            robot.keyPress(code);
        }
        for (int i = codes.length - 1; i >= 0; i--) {
            robot.keyRelease(codes[i]);
        }
        robot.waitForIdle();
    }

    void type(String lowerCase) {
        for (char c : lowerCase.toCharArray()) {
            keys(KeyEvent.getExtendedKeyCodeForChar(c));
        }
    }

    /** Finds a component of the window, or of a dialog that belongs to it, by its name. */
    Component find(String name) {
        return OnEventThread.get(
                () -> look(name).orElseThrow(() -> new AssertionError("no component " + name + " in the window")));
    }

    /** Tells whether there is a component of a name to be seen. */
    boolean shows(String name) {
        return OnEventThread.get(() -> look(name).filter(Component::isShowing).isPresent());
    }

    private Optional<Component> look(String name) {
        for (Window dialog : window.frame().getOwnedWindows()) {
            Optional<Component> found = dialog.isShowing() ? Named.find(dialog, name) : Optional.empty();
            if (found.isPresent()) {
                return found;
            }
        }
        return Named.find(window.frame(), name);
    }

    /** Returns what a component shows on the screen. */
    BufferedImage picture(Component component) {
        robot.waitForIdle();
        Point at = onScreen(component, 0, 0);
        return robot.createScreenCapture(new Rectangle(at.x, at.y, component.getWidth(), component.getHeight()));
    }

    /** Returns the share of pixels in which two pictures of one size differ. */
    static double difference(BufferedImage a, BufferedImage b) {
        int differing = 0;
        for (int y = 0; y < a.getHeight(); y++) {
            for (int x = 0; x < a.getWidth(); x++) {
                differing += a.getRGB(x, y) != b.getRGB(x, y) ? 1 : 0;
            }
        }
        return differing / (double) (a.getWidth() * a.getHeight());
    }

    /** Closes the window and fails if work was done on the wrong thread, or something was thrown there. */
    @Override
    public void close() {
        Thread.setDefaultUncaughtExceptionHandler(null);
        watch.close();
        OnEventThread.run(() -> {
            window.dispose();
            RepaintManager.setCurrentManager(new RepaintManager());
        });
        if (uncaught.get() != null) {
            throw new AssertionError("thrown in the window", uncaught.get());
        }
        watch.found().ifPresent(frame -> {
            throw new AssertionError("on the event thread: " + frame);
        });
        if (!guard.wrong().isEmpty()) {
            throw new AssertionError("painting asked for off the event thread: " + guard.wrong());
        }
    }
}
