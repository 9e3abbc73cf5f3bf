package troupe.app.panel.inspector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Component;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Studios;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.plan.PlanningSteps;
import troupe.app.session.Session;
import troupe.paint.Theme;
import troupe.run.Engine;
import troupe.run.view.Overlay;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;

class WhySectionTest {
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
            assertFalse(EventQueue.isDispatchThread());
            return Tasks.start(scene, task);
        }

        @Override
        public List<Overlay> overlays(
                Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
            return List.of();
        }
    };

    private static String note(WhySection section) {
        return Stream.of(section.getComponents())
                .filter(c -> "why.note".equals(c.getName()))
                .map(c -> ((JTextComponent) c).getText())
                .findFirst()
                .orElse("");
    }

    private static String table(WhySection section) {
        return Stream.of(section.getComponents())
                .filter(c -> "why.table".equals(c.getName()))
                .map(Component::getAccessibleContext)
                .map(c -> c.getAccessibleName())
                .findFirst()
                .orElse("");
    }

    @Test
    void saysWhatWouldChangeThePlanUntilItHasChanged() throws SceneException, IOException {
        Scene scene =
                SceneXml.read(Path.of("scenes", "unified", "three-ways.xml")).scene();
        Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
        try (Session session = OnEventThread.get(() -> new Session(
                new SceneDocument(scene, Optional.empty()), STEPS, Studios.NO_FILES, EventQueue::invokeLater))) {
            WhySection section = OnEventThread.get(() -> {
                WhySection made = new WhySection(look, session);
                session.planNow();
                return made;
            });
            Await.until(
                    "the flip is told",
                    () -> note(section)
                            .equals(
                                    "Moves Crate over 0.9 m.\nIf moving things cost 2.3 times as much, Kit would vault instead."));
            assertEquals(true, OnEventThread.get(() -> table(section)).contains("Without moving"));
            Journey journey = (Journey) scene.task("past-the-crate").orElseThrow();
            Scene dear = scene.with(journey.preferring(journey.preferences().with(Ability.MOVE, 2.4)));
            OnEventThread.run(() -> session.document().commit("Preference: move", dear));
            Await.until(
                    "he vaults, and moves nothing any more",
                    () -> session.plan().filter(p -> p.why().isPresent()).isPresent()
                            && note(section).startsWith("If vaulting cost ")
                            && !table(section).contains("Without moving"));
        }
    }
}
