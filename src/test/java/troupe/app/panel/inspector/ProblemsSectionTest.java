package troupe.app.panel.inspector;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.EventQueue;
import java.awt.Point;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.ScriptedSteps;
import troupe.app.Studios;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.plan.PlanningSteps;
import troupe.app.problem.Diagnosis;
import troupe.app.session.Session;
import troupe.paint.Theme;
import troupe.run.Engine;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;

/** Lets problems come up while the pointer moves in the inspector, and while it rests. */
class ProblemsSectionTest {
    /** Finds one thing wrong with every scene. */
    private static final class Wrong implements PlanningSteps {
        private final PlanningSteps steps = new ScriptedSteps(1, () -> {});

        @Override
        public List<Problem> check(Scene scene) {
            return List.of(new Problem(Severity.ERROR, "crate", 0, "the polygon has no area", ""));
        }

        @Override
        public List<Problem> inspect(Scene scene) {
            return List.of();
        }

        @Override
        public Engine start(Scene scene, String task) {
            return steps.start(scene, task);
        }

        @Override
        public List<Overlay> overlays(
                Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
            return List.of();
        }
    }

    /** What came up under a pointer on its way made it press another thing than it aimed at. */
    @Test
    void theListWaitsUntilThePointerRests() {
        PlanningSteps steps = new Wrong();
        AtomicBoolean moving = new AtomicBoolean(true);
        AtomicInteger places = new AtomicInteger();
        Session session = OnEventThread.get(() -> new Session(
                new SceneDocument(Scenes.room(), Optional.empty()), steps, Studios.NO_FILES, EventQueue::invokeLater));
        Diagnosis diagnosis = OnEventThread.get(() -> new Diagnosis(session, steps, EventQueue::invokeLater));
        try {
            ProblemsSection section = OnEventThread.get(() -> new ProblemsSection(
                    new Look(Theme.LIGHT, new Texts(Locale.ENGLISH)),
                    session,
                    diagnosis,
                    box -> {},
                    s -> new Point(moving.get() ? places.incrementAndGet() : -1, 0)));
            OnEventThread.run(session::planNow);
            Await.until("it is found", () -> !diagnosis.findings().problems().isEmpty());
            Await.until("it was looked at once more", () -> places.get() > 2);
            assertFalse(OnEventThread.get(section::isVisible), "the pointer is on its way");
            moving.set(false);
            Await.until("the list comes up", section::isVisible);
        } finally {
            OnEventThread.run(() -> {
                diagnosis.close();
                session.close();
            });
        }
    }
}
