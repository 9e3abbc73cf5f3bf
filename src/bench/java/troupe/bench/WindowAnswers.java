package troupe.bench;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import javax.swing.JFrame;
import javax.swing.RepaintManager;
import troupe.app.canvas.Canvas;
import troupe.app.document.SceneDocument;
import troupe.app.document.Version;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.plan.Plan;
import troupe.app.session.Session;
import troupe.app.tool.Editing;
import troupe.app.tool.select.SelectTool;
import troupe.grid.region.Groundworks;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/**
 * Measures how soon the canvas answers: {@code WindowAnswers SCENE OBSTACLE SECONDS}. Holds the mouse on an obstacle and
 * moves it round in a small circle, an event every 16 ms, and prints how long it took from the event whose scene was
 * planned until that plan was painted; then drops plans of a hall of 1024 × 1024 cells after random times, and prints
 * how long it took until a small room was planned instead.
 */
public final class WindowAnswers {
    private static final int MOVE_MS = 16;
    private static final int WARM_S = 12;
    private static final double RADIUS_M = 0.06;
    private static final int CANCELS = 100;

    private final Map<Version, Long> asked = new HashMap<>();
    private final List<Double> answers = new ArrayList<>();
    private final BlockingQueue<Plan> told = new LinkedBlockingQueue<>();
    private final Scene scene;
    private Session session;
    private Canvas canvas;
    private Version planned;
    private Version prepared;
    private boolean measuring;
    private int moves;

    private WindowAnswers(Scene scene) {
        this.scene = scene;
    }

    /** Opens a window, drags, cancels, prints, and ends the program. */
    public static void main(String[] words) throws Exception {
        Scene scene = SceneXml.read(Path.of(words[0])).scene();
        WindowAnswers answers = new WindowAnswers(scene);
        EventQueue.invokeAndWait(answers::open);
        answers.drag(scene.obstacle(words[1]).orElseThrow(), Integer.parseInt(words[2]));
        answers.cancel();
        System.exit(0);
    }

    private void open() {
        Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
        session = new Session(
                new SceneDocument(scene, Optional.empty()),
                new DragBench.Steps(true, new Groundworks()),
                DragBench.NO_FILES,
                EventQueue::invokeLater);
        session.plans().add(plan -> {
            planned = plan.snapshot().version();
            told.add(plan);
        });
        canvas = new Canvas(
                look,
                session,
                task -> EventQueue.invokeLater(() -> {
                    task.run();
                    prepared = planned;
                }));
        Viewport[] view = {canvas.view()};
        canvas.views().add(v -> view[0] = v);
        canvas.take(
                new SelectTool(new Editing(session.document(), session.selection(), look, () -> view[0], () -> {})));
        RepaintManager.setCurrentManager(new Painted());
        JFrame frame = new JFrame();
        frame.add(canvas, BorderLayout.CENTER);
        frame.setSize(1100, 760);
        frame.setVisible(true);
        session.planNow();
    }

    /** Notes when a plan is on the screen. */
    private final class Painted extends RepaintManager {
        @Override
        public void paintDirtyRegions() {
            Version shown = prepared;
            super.paintDirtyRegions();
            Toolkit.getDefaultToolkit().sync();
            Long begin = asked.remove(shown);
            if (begin != null && measuring) {
                answers.add((System.nanoTime() - begin) / 1e6);
            }
        }
    }

    private void drag(Obstacle obstacle, int seconds) throws Exception {
        LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(2));
        troupe.geometry.Point middle = obstacle.outline().centroid();
        mouse(MouseEvent.MOUSE_PRESSED, middle.x(), middle.y());
        int all = (WARM_S + seconds) * 1000 / MOVE_MS;
        for (int k = 0; k < all; k++) {
            double angle = 2 * Math.PI * k / 60;
            mouse(
                    MouseEvent.MOUSE_DRAGGED,
                    middle.x() + RADIUS_M * Math.cos(angle),
                    middle.y() + RADIUS_M * Math.sin(angle));
            boolean warm = k * MOVE_MS > WARM_S * 1000;
            EventQueue.invokeLater(() -> {
                measuring = warm;
                moves += warm ? 1 : 0;
            });
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(MOVE_MS));
        }
        EventQueue.invokeAndWait(() -> print("from the event to the plan on the screen", answers));
        System.out.printf(Locale.ROOT, "%d plans shown for %d events in %d s%n", answers.size(), moves, seconds);
        mouse(MouseEvent.MOUSE_RELEASED, middle.x(), middle.y());
    }

    private void mouse(int id, double x, double y) throws Exception {
        EventQueue.invokeAndWait(() -> {
            int held = id == MouseEvent.MOUSE_RELEASED ? 0 : InputEvent.BUTTON1_DOWN_MASK;
            int button = id == MouseEvent.MOUSE_DRAGGED ? MouseEvent.NOBUTTON : MouseEvent.BUTTON1;
            Point at = new Point((int) Math.round(canvas.view().px(x)), (int)
                    Math.round(canvas.view().py(y)));
            long begin = System.nanoTime();
            canvas.dispatchEvent(
                    new MouseEvent(canvas, id, System.currentTimeMillis(), held, at.x, at.y, 1, false, button));
            asked.putIfAbsent(session.document().version(), begin);
        });
    }

    /** Drops the plan of a large hall after some time by opening a small room, and waits for the plan of that. */
    private void cancel() throws Exception {
        Scene hall = crossed(1024);
        Scene room = crossed(64);
        List<Double> took = new ArrayList<>();
        Random random = new Random(7);
        for (int k = 0; k < CANCELS; k++) {
            EventQueue.invokeAndWait(() -> session.document().open(hall, Optional.empty()));
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(random.nextInt(400)));
            long[] begin = {0};
            EventQueue.invokeAndWait(() -> {
                begin[0] = System.nanoTime();
                session.planner().cancel();
                session.document().open(room, Optional.empty());
            });
            while (told.take().snapshot().scene() != room) {
                continue;
            }
            took.add((System.nanoTime() - begin[0]) / 1e6);
            told.clear();
        }
        print("from cancelling a plan to that of another scene", took);
    }

    private static Scene crossed(int size) {
        Scene hall = GeneratedScenes.hall(size);
        double far = GeneratedScenes.SIDE - 0.7;
        return new Scene(
                "",
                hall.world(),
                hall.obstacles(),
                List.of(),
                List.of(Actor.standard("ann")),
                List.of(Journey.of("across", "ann", Place.of(0.7, 0.7), Place.of(far, far))));
    }

    private static void print(String what, List<Double> all) {
        double[] sorted = all.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        System.out.printf(
                Locale.ROOT,
                "%s: ms median %.1f, 99 %% %.1f, longest %.1f%n",
                what,
                sorted[sorted.length / 2],
                sorted[sorted.length * 99 / 100],
                sorted[sorted.length - 1]);
    }
}
