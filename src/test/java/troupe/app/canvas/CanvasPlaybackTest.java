package troupe.app.canvas;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Studios;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.plan.PlanningSteps;
import troupe.app.session.Session;
import troupe.paint.Sketch;
import troupe.paint.Theme;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.search.Outcome;

/** Looks at the canvas while a run is played that moves the crate of the sketch, without a window. */
class CanvasPlaybackTest {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 760;

    private Session session;
    private Canvas canvas;

    /** An engine that has found the way of the sketch at once. */
    private static final Engine FOUND = new Engine() {
        @Override
        public Outcome step(long budget) {
            return Outcome.FOUND;
        }

        @Override
        public Outcome outcome() {
            return Outcome.FOUND;
        }

        @Override
        public void cancel() {}

        @Override
        public Progress progress() {
            return new Progress(1, 1);
        }

        @Override
        public List<Overlay> overlays() {
            return List.of(Sketch.skeleton());
        }

        @Override
        public Run run() {
            return Sketch.haul();
        }
    };

    private static final PlanningSteps STEPS = new PlanningSteps() {
        @Override
        public List<Problem> check(Scene scene) {
            return List.of();
        }

        @Override
        public List<Problem> inspect(Scene scene) {
            return List.of();
        }

        @Override
        public Engine start(Scene scene, String task) {
            return FOUND;
        }

        @Override
        public List<Overlay> overlays(
                Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
            return engine.overlays(chosen, wanted);
        }
    };

    @BeforeEach
    void open() {
        OnEventThread.run(() -> {
            session = new Session(
                    new SceneDocument(Sketch.scene(), Optional.empty()),
                    STEPS,
                    Studios.NO_FILES,
                    EventQueue::invokeLater);
            canvas = new Canvas(new Look(Theme.LIGHT, new Texts(Locale.ENGLISH)), session, EventQueue::invokeLater);
            canvas.setSize(WIDTH, HEIGHT);
            canvas.fit();
            session.planNow();
        });
        Await.until("the plan is painted", () -> pixel(paint(9), 10.25, 8.5));
    }

    @AfterEach
    void close() {
        OnEventThread.run(() -> {
            canvas.close();
            session.close();
        });
    }

    private BufferedImage paint(double time) {
        session.playback().seek(time);
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        canvas.paintComponent(g);
        g.dispose();
        return image;
    }

    private int[] shown(double time) {
        BufferedImage image = OnEventThread.get(() -> paint(time));
        return image.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
    }

    /** Tells whether most of the pixels around a place are of solid wood. */
    private boolean pixel(BufferedImage image, double x, double y) {
        int column = (int) canvas.view().px(x);
        int row = (int) canvas.view().py(y);
        int wood = 0;
        for (int k = 0; k < 25; k++) {
            Color c = new Color(image.getRGB(column + k % 5 - 2, row + k / 5 - 2));
            wood += c.getRed() < 190 && c.getRed() - c.getBlue() > 70 ? 1 : 0;
        }
        return wood > 15;
    }

    private void assertCrate(double time, boolean first, boolean last) {
        BufferedImage image = OnEventThread.get(() -> paint(time));
        assertEquals(first, pixel(image, 8.45, 7.15), "at its first place at " + time + " s");
        assertEquals(last, pixel(image, 10.25, 8.5), "at its last place at " + time + " s");
    }

    @Test
    void crateIsWhereItIsAtTheMomentShown() {
        assertCrate(0, true, false);
        assertCrate(8, false, false);
        assertCrate(9.5, false, true);
        assertCrate(6.9, true, false);
        assertCrate(10, false, true);
    }

    @Test
    void momentLooksTheSameHoweverItWasReached() {
        int[] underWay = shown(8);
        int[] later = shown(8.2);
        int[] before = shown(1);
        assertArrayEquals(underWay, shown(8), "back from before it was moved");
        assertArrayEquals(later, shown(8.2));
        shown(10);
        assertArrayEquals(before, shown(1), "back from the end");
    }

    @Test
    void crateThatIsDraggedFollowsTheMouseWhateverTheOldPlanSays() {
        OnEventThread.run(() -> {
            Obstacle crate = session.document().scene().obstacle("crate").orElseThrow();
            session.document()
                    .preview(session.document()
                            .scene()
                            .with(crate.withOutline(crate.outline().shifted(-3, -4))));
        });
        BufferedImage image = OnEventThread.get(() -> paint(9.5));
        assertTrue(pixel(image, 5.45, 3.15), "the crate is under the mouse");
        assertFalse(pixel(image, 10.25, 8.5), "and not where the plan had moved it");
    }
}
