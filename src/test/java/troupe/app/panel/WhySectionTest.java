package troupe.app.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Component;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
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
import troupe.run.Overlay;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Problem;
import troupe.scene.Scene;
import troupe.scene.SceneException;
import troupe.scene.SceneXml;
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
        public List<Overlay> overlays(Scene scene, String task, Engine engine, List<Integer> chosen) {
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
                SceneXml.read(Path.of("scenes", "unified", "courtyard.xml")).scene();
        Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
        try (Session session = OnEventThread.get(() -> new Session(
                new SceneDocument(scene, Optional.empty()), STEPS, Studios.NO_FILES, EventQueue::invokeLater))) {
            WhySection section = OnEventThread.get(() -> {
                WhySection made = new WhySection(look, session);
                session.planNow();
                return made;
            });
            Await.until("the flip is told", () -> note(section)
                    .equals("Moves Crate over 1.0 m.\nIf vaulting cost 3.6 times as much, Ann would walk round."));
            assertEquals(true, OnEventThread.get(() -> table(section)).contains("Without vaulting"));
            Journey journey = (Journey) scene.task("to-the-fountain").orElseThrow();
            Scene dear = scene.with(journey.preferring(journey.preferences().with(Ability.VAULT, 4.2)));
            OnEventThread.run(() -> session.document().commit("Preference: vault", dear));
            Await.until(
                    "she walks round, and nothing else is to be said",
                    () -> session.plan().filter(p -> p.why().isPresent()).isPresent()
                            && note(section).matches("Moves Crate over \\d\\.\\d m\\.")
                            && !table(section).contains("Without vaulting"));
        }
    }
}
