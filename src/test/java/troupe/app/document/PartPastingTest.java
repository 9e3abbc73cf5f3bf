package troupe.app.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.xml.SceneXml;

/** Takes avatars and groups from scene to scene as the clipboard does, and moves and removes them with other things. */
class PartPastingTest {
    private static Scene sample(String file) throws Exception {
        return SceneXml.read(Path.of("scenes", file)).scene();
    }

    /** Returns a scene after it has been written and read. */
    private static Scene carried(Scene part) throws Exception {
        byte[] text = SceneXml.write(part).getBytes(StandardCharsets.UTF_8);
        return SceneXml.read(new ByteArrayInputStream(text), "clipboard").scene();
    }

    private static Encounter encounter(Scene scene) {
        return (Encounter) scene.task("cross").orElseThrow();
    }

    @Test
    void anAvatarIsPastedIntoItsTaskBesideItselfWithItsWholeWay() throws Exception {
        Scene scene = sample("risk/crossing.xml");
        Scene part = carried(Pasting.extract(scene, List.of("cross/bob", "kiosk")));
        Pasting.Pasted pasted = Pasting.into(scene, part, "cross");
        assertEquals(List.of("kiosk-1", "cross/bob-1"), pasted.ids());
        Avatar bob = encounter(scene).avatar("bob").orElseThrow();
        Avatar copy = encounter(pasted.scene()).avatar("bob-1").orElseThrow();
        assertEquals("Bob 2", copy.label());
        assertEquals(Optional.of(Place.of(1.5, 5.9)), Mark.start(copy));
        assertEquals(Place.of(5.7, 8.1), Mark.heads(copy).get(0).to());
        assertEquals(Mark.heads(bob).get(1).at(), Mark.heads(copy).get(1).at());
        assertEquals(1, pasted.scene().tasks().size());
        assertEquals(
                List.of("kiosk-1"),
                SceneChecks.check(pasted.scene()).stream().map(Problem::element).toList());
    }

    @Test
    void whatWasCutComesBackWhereItWas() throws Exception {
        Scene scene = sample("risk/crossing.xml");
        Scene part = carried(Pasting.extract(scene, List.of("cross/bob")));
        Scene cut = SceneEdits.removed(scene, List.of("cross/bob"));
        assertEquals(List.of(), encounter(cut).avatars());
        assertEquals(scene, Pasting.into(cut, part, "cross").scene());
    }

    @Test
    void aGroupBringsTheGoalThatItWasGivenFromAbove() throws Exception {
        Scene scene = sample("crowd/fork.xml");
        Scene part = carried(Pasting.extract(scene, List.of("fork/blue")));
        Pasting.Pasted pasted = Pasting.into(scene, part, "fork");
        assertEquals(List.of("fork/blue-1"), pasted.ids());
        CrowdGroup copy = ((Crowd) pasted.scene().task("fork").orElseThrow())
                .group("blue-1")
                .orElseThrow();
        assertEquals(Optional.of(Place.of(10, 27)), copy.goal());
        assertEquals(
                Polygon.of(8.7, 0.5, 10.5, 0.5, 10.5, 5.5, 8.7, 5.5),
                copy.members().orElseThrow().spawn());
    }

    @Test
    void aFamilyIsCopiedOnceWithAllInIt() throws Exception {
        Scene scene = sample("crowd/fork.xml");
        Scene part = carried(Pasting.extract(scene, List.of("fork/platoon", "fork/blue")));
        Crowd crowd = (Crowd) Pasting.into(scene, part, "").scene().task("fork").orElseThrow();
        assertEquals(
                List.of("platoon", "blue", "black", "platoon-1", "blue-1", "black-1"),
                crowd.allGroups().map(CrowdGroup::id).toList());
    }

    @Test
    void groupsMakeACrowdWhereThereIsNoneAndAvatarsNeedAnEncounter() throws Exception {
        Scene courtyard = sample("unified/courtyard.xml");
        Scene groups = Pasting.extract(sample("crowd/fork.xml"), List.of("fork/blue"));
        Pasting.Pasted pasted = Pasting.into(courtyard, groups, "to-the-fountain");
        assertEquals(List.of("crowd-1/blue"), pasted.ids());
        assertEquals(courtyard.tasks().size() + 1, pasted.scene().tasks().size());
        Scene avatars = Pasting.extract(sample("risk/crossing.xml"), List.of("cross/bob"));
        assertEquals(new Pasting.Pasted(courtyard, List.of()), Pasting.into(courtyard, avatars, ""));
    }

    @Test
    void placesMoveWithWhatIsSelectedAndNoneMovesTwice() throws Exception {
        Scene scene = sample("risk/crossing.xml");
        List<String> ids = List.of("cross", "cross#start", "cross#goal", "cross/bob", "cross/bob#0", "cross/bob#1");
        ids.forEach(id -> assertTrue(Parts.isThere(scene, id), id));
        Encounter moved = encounter(SceneEdits.shifted(scene, ids, 0.5, -0.25));
        assertEquals(Place.of(5.5, 0.55), moved.start());
        assertEquals(Place.of(5.5, 8.95), moved.goal());
        Avatar bob = moved.avatar("bob").orElseThrow();
        assertEquals(Optional.of(Place.of(1.5, 6.15)), Mark.start(bob));
        assertEquals(
                List.of(Place.of(5.7, 8.35), Place.of(9.7, 3.95)),
                Mark.heads(bob).stream().map(Avatar.Head::to).toList());
    }

    @Test
    void goalsOfAvatarsAreDeletedAndEndsOfTasksStay() throws Exception {
        Scene scene = sample("risk/crossing.xml");
        Scene without = SceneEdits.removed(scene, List.of("cross/bob#0", "cross#start"));
        Avatar bob = encounter(without).avatar("bob").orElseThrow();
        assertEquals(
                List.of(Place.of(9.2, 4.2)),
                Mark.heads(bob).stream().map(Avatar.Head::to).toList());
        assertEquals(encounter(scene).start(), encounter(without).start());
        Scene none = SceneEdits.removed(scene, List.of("cross/bob#0", "cross/bob#1"));
        assertEquals(List.of(), Mark.heads(encounter(none).avatar("bob").orElseThrow()));
    }
}
