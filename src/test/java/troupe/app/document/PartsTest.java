package troupe.app.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.geometry.Polygon;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

class PartsTest {
    private static final Polygon SPAWN = Polygon.rectangle(1, 1, 3, 3);

    private static CrowdGroup group(String id, double goal) {
        return CrowdGroup.of(id, Place.of(goal, 5), CrowdGroup.Members.of(4, SPAWN));
    }

    private static Scene crowd() {
        Crowd crowd = Crowd.of("c", List.of(group("a", 8), group("b", 8), group("d", 2)));
        return NewElements.with(Scenes.room(), crowd);
    }

    private static List<String> tree(Scene scene) {
        return ((Crowd) scene.task("c").orElseThrow())
                .allGroups()
                .map(g -> g.id()
                        + (g.goal().isPresent() ? " to " + (int) g.goal().get().x() : "") + " "
                        + g.parts().size())
                .toList();
    }

    @Test
    void groupsAreJoinedAndPartedAgain() {
        Scene scene = crowd();
        List<String> ids = List.of("c/a", "c/b");
        assertTrue(CrowdEdits.canJoin(scene, ids));
        assertFalse(CrowdEdits.canJoin(scene, List.of("c/a")));
        assertFalse(CrowdEdits.canJoin(scene, List.of("c/a", "crate")));
        Scene joined = CrowdEdits.joined(scene, ids, "f", "Family");
        assertEquals(List.of("f to 8 2", "a 0", "b 0", "d to 2 0"), tree(joined));
        assertFalse(CrowdEdits.canJoin(joined, List.of("c/a", "c/d")));
        Scene twice = CrowdEdits.joined(joined, List.of("c/f", "c/d"), "g", "All");
        assertEquals(List.of("g 2", "f to 8 2", "a 0", "b 0", "d to 2 0"), tree(twice));
        assertEquals(scene, CrowdEdits.parted(CrowdEdits.parted(twice, "c/g"), "c/f"));
        assertThrows(IllegalArgumentException.class, () -> CrowdEdits.parted(scene, "c/a"));
        assertThrows(IllegalArgumentException.class, () -> CrowdEdits.joined(scene, List.of("c/a"), "f", ""));
    }

    @Test
    void relationsOfDepthsThatAreLeftGoWithThem() {
        Scene joined = CrowdEdits.joined(crowd(), List.of("c/a", "c/b"), "f", "");
        Crowd deep = ((Crowd) joined.task("c").orElseThrow()).with(new Crowd.Relation(2, 9, 9, 9));
        Scene parted = CrowdEdits.parted(joined.with(deep), "c/f");
        assertEquals(List.of(), ((Crowd) parted.task("c").orElseThrow()).relations());
    }

    @Test
    void removingTheLastPartTakesTheFamilyAndTheCrowdAway() {
        Scene joined = CrowdEdits.joined(crowd(), List.of("c/a", "c/b"), "f", "");
        assertEquals(List.of("d to 2 0"), tree(SceneEdits.removed(joined, List.of("c/a", "c/b"))));
        assertEquals(Scenes.room(), SceneEdits.removed(joined, List.of("c/a", "c/b", "c/d")));
        assertEquals(Scenes.room(), SceneEdits.removed(joined, List.of("c", "c/a")));
    }

    @Test
    void whereAGroupStandsIsShiftedAndReshapedAsAThing() {
        Scene moved = SceneEdits.shifted(crowd(), List.of("c/b", "crate"), 0.5, 0.25);
        assertEquals(
                Polygon.rectangle(1.5, 1.25, 3.5, 3.25),
                SceneEdits.outline(moved, "c/b").orElseThrow());
        assertEquals(SPAWN, SceneEdits.outline(moved, "c/a").orElseThrow());
        assertEquals(
                Polygon.rectangle(4.5, 3.25, 5.5, 4.25),
                SceneEdits.outline(moved, "crate").orElseThrow());
        Polygon other = Polygon.rectangle(0, 0, 1, 1);
        Scene bent = SceneEdits.reshaped(moved, List.of("c/b"), before -> other);
        assertEquals(other, SceneEdits.outline(bent, "c/b").orElseThrow());
        assertEquals(Optional.empty(), SceneEdits.outline(bent, "c"));
    }

    @Test
    void everyPlaceOfATaskIsAMarkThatMoves() throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/risk/crossing.xml")).scene();
        Encounter encounter = (Encounter) scene.tasks().get(0);
        List<Mark> marks = Mark.of(encounter);
        assertEquals(
                List.of(Mark.Kind.AVATAR, Mark.Kind.HEAD, Mark.Kind.HEAD, Mark.Kind.START, Mark.Kind.GOAL),
                marks.stream().map(Mark::kind).toList());
        Scene moved = scene;
        for (Mark mark : marks) {
            moved = mark.moved(
                    moved, Place.of(mark.place().x() + 0.5, mark.place().y()));
        }
        List<Mark> after = Mark.of(moved.tasks().get(0));
        for (int i = 0; i < marks.size(); i++) {
            assertEquals(marks.get(i).place().x() + 0.5, after.get(i).place().x(), 1e-9);
        }
        assertEquals(
                Mark.heads(encounter.avatars().get(0)).get(1).at(),
                Mark.heads(((Encounter) moved.tasks().get(0)).avatars().get(0))
                        .get(1)
                        .at());
        Mark goal = Mark.of(crowd().task("c").orElseThrow()).get(2);
        assertEquals("c/d", goal.owner());
        assertEquals(List.of("a to 8 0", "b to 8 0", "d to 6 0"), tree(goal.moved(crowd(), Place.of(6, 6))));
    }

    @Test
    void anUnknownPartIsNotThereAndChangesNothing() {
        Scene scene = crowd();
        assertTrue(Parts.isThere(scene, "c/a"));
        assertTrue(Parts.isThere(scene, "crate"));
        assertFalse(Parts.isThere(scene, "c/x"));
        assertFalse(Parts.isThere(scene, "x/a"));
        assertFalse(Parts.isThere(scene, "there/a"));
        assertSame(scene, Parts.withGroup(scene, "c/x", g -> g));
        assertSame(scene, Parts.withAvatar(scene, "c/a", a -> a));
        assertEquals(scene, SceneEdits.removed(scene, List.of("c/x", "there/x")));
        assertEquals("c/x", SceneEdits.name(scene, "c/x"));
        Avatar recorded = Avatar.of("r", new Avatar.Recording(List.of()));
        assertSame(recorded, Mark.starting(recorded, Place.of(1, 1)));
    }
}
