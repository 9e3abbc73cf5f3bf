package troupe.app.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.scene.Crowd;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.check.Severity;
import troupe.scene.xml.SceneXml;

class PastingTest {
    private static Scene sample(String file) throws Exception {
        return SceneXml.read(Path.of("scenes", file)).scene();
    }

    private static List<Problem> errors(Scene scene) {
        return SceneChecks.check(scene).stream()
                .filter(p -> p.severity() == Severity.ERROR)
                .toList();
    }

    @Test
    void aCrowdPastedTwiceGetsAnotherId() throws Exception {
        Scene scene = sample("crowd/fork.xml");
        Crowd crowd = (Crowd) scene.tasks().get(0);
        Pasting.Pasted pasted = Pasting.into(scene, scene, "");
        Crowd second = (Crowd) pasted.scene().tasks().get(1);
        assertEquals(crowd, second.named(crowd.id(), crowd.label()));
        assertTrue(pasted.ids().contains(second.id()));
        assertEquals(List.of(), errors(pasted.scene()));
    }

    @Test
    void anEncounterPastedWithItsActorIsOfTheNewOne() throws Exception {
        Scene scene = sample("risk/crossing.xml");
        Encounter encounter = (Encounter) scene.tasks().get(0);
        Pasting.Pasted pasted = Pasting.into(scene, scene, "");
        List<String> old = scene.elements().map(Element::id).toList();
        Encounter second = (Encounter) pasted.scene().tasks().get(scene.tasks().size());
        assertTrue(!old.contains(second.id()) && !old.contains(second.actor()), second.toString());
        assertEquals(encounter.avatars(), second.avatars());
        assertEquals(List.of(), errors(pasted.scene()));
    }
}
