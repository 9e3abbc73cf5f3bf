package troupe.app.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import troupe.app.look.Texts;
import troupe.scene.Scene;
import troupe.scene.SceneException;
import troupe.scene.SceneXml;
import troupe.work.Explainer;
import troupe.work.Explanation;
import troupe.work.Tasks;

class PlanWordsTest {
    private static Explanation explain(String file, String task) throws SceneException, IOException {
        Scene scene = SceneXml.read(Path.of("scenes", "unified", file)).scene();
        Explainer explainer =
                new Explainer((other, id) -> Tasks.start(other, id).finish());
        return explainer.explain(Tasks.start(scene, task).finish());
    }

    @Test
    void saysWhenAnActorWouldWalkRound() throws SceneException, IOException {
        Explanation courtyard = explain("courtyard.xml", "to-the-fountain");
        assertEquals(
                "If vaulting cost 4.1 times as much, Ann would walk round.",
                PlanWords.flips(courtyard, new Texts(Locale.ENGLISH)));
        assertEquals("若翻越的代價變為 4.1 倍，Ann 就會繞道行走。", PlanWords.flips(courtyard, new Texts(Locale.TRADITIONAL_CHINESE)));
    }

    @Test
    void saysWhatAnActorWouldDoInstead() throws SceneException, IOException {
        Explanation apartment = explain("apartment.xml", "kitchen-to-bedroom");
        String actor = apartment.plan().run().scene().actors().get(0).name();
        assertEquals(
                "If sidestepping cost 5.1 times as much, " + actor + " would vault instead.",
                PlanWords.flips(apartment, new Texts(Locale.ENGLISH)));
        assertEquals(
                "若側行的代價變為 5.1 倍，" + actor + " 就會改為翻越。",
                PlanWords.flips(apartment, new Texts(Locale.TRADITIONAL_CHINESE)));
    }

    @Test
    void saysNothingOfWalking() throws SceneException, IOException {
        assertEquals("", PlanWords.flips(explain("two-ways.xml", "to-the-hall"), new Texts(Locale.ENGLISH)));
    }
}
