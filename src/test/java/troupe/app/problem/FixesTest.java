package troupe.app.problem;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.app.document.NewElements;
import troupe.app.document.SceneEdits;
import troupe.geometry.Polygon;
import troupe.geometry.SelfIntersection;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.scene.xml.SceneSource;
import troupe.work.inspect.SceneInspection;

/** Breaks a small room, and mends it with the first fix that is offered. */
class FixesTest {
    private static List<Problem> problems(Scene scene) {
        return SceneInspection.check(new SceneSource(scene, Map.of()));
    }

    private static Fix first(Scene scene, String element) {
        return problems(scene).stream()
                .filter(p -> p.element().equals(element))
                .flatMap(p -> Fixes.of(scene, p).stream())
                .findFirst()
                .orElseThrow(() -> new AssertionError("no fix among " + problems(scene)));
    }

    private static void mends(Scene scene, String element, String key) {
        Fix fix = first(scene, element);
        assertEquals(key, fix.key());
        assertTrue(
                problems(fix.mended()).stream().noneMatch(p -> p.element().equals(element)),
                () -> problems(fix.mended()).toString());
    }

    private static Scene with(Polygon outline) {
        Scene room = Scenes.room();
        return room.with(room.obstacle("crate").orElseThrow().withOutline(outline));
    }

    @Test
    void theEndsOfAnEncounterLeaveTheObstaclesTheyStandIn() {
        Scene wall = Scenes.room()
                .with(new Obstacle("crate", "", Polygon.rectangle(4, 3, 5, 4), 0, 3, false, Obstacle.DEFAULT_MASS, ""));
        String actor = wall.actors().get(0).id();
        Avatar through = Avatar.of(
                "bob",
                new Avatar.Script(
                        Place.of(4.5, 1), 1, List.of(new Avatar.Head(Place.of(4.5, 5), OptionalDouble.empty()))));
        Encounter meet = Encounter.of("meet", actor, Place.of(4.5, 3.5), Place.of(1, 1), List.of(through));
        Scene wrong = NewElements.with(wall, meet);
        Fix fix = first(wrong, "meet");
        assertEquals("fix.start", fix.key());
        List<Problem> left = problems(fix.mended()).stream()
                .filter(p -> p.element().equals("meet"))
                .toList();
        assertEquals(1, left.size(), left::toString);
        assertEquals(Severity.WARNING, left.get(0).severity());
        assertEquals(List.of(), Fixes.of(fix.mended(), left.get(0)));
        Scene lost = wrong.with(meet.between(Place.of(1, 1), Place.of(4.5, 3.5)));
        assertEquals("fix.goal", first(lost, "meet").key());
        assertEquals(
                "fix.actor", first(wrong.with(meet.withActor("nobody")), "meet").key());
    }

    @Test
    void theStartLeavesTheObstacleItStandsIn() {
        Scene room = Scenes.room();
        Journey there = (Journey) room.task("there").orElseThrow();
        Scene within = SceneEdits.startingAt(room, there, Place.of(4.5, 3.5));
        Scene high = within.with(
                new Obstacle("crate", "", Polygon.rectangle(4, 3, 5, 4), 0, 3, false, Obstacle.DEFAULT_MASS, ""));
        mends(high, "there", "fix.start");
    }

    @Test
    void aTwistedOutlineIsUntangled() {
        mends(with(Polygon.of(4, 3, 5, 4, 5, 3, 4, 4)), "crate", "fix.untangle");
        mends(with(Polygon.of(4, 3, 5, 3, 5, 3, 5, 4, 4, 4)), "crate", "fix.untangle");
        Polygon star = Polygon.of(5, 2, 6, 5, 3.5, 3.2, 6.5, 3.2, 4, 5);
        Polygon simple = Fixes.untangled(star).orElseThrow();
        assertEquals(Optional.empty(), SelfIntersection.find(simple));
        assertEquals(5, simple.size());
    }

    @Test
    void whatLiesOutsideComesIn() {
        mends(with(Polygon.rectangle(12, 3, 13, 4)), "crate", "fix.inside");
        mends(with(Polygon.rectangle(-0.5, 3, 0.5, 4)), "crate", "fix.inside");
    }

    @Test
    void whatHangsInTheAirComesDown() {
        Scene room = Scenes.room();
        Scene hanging = room.with(
                new Obstacle("crate", "", Polygon.rectangle(4, 3, 5, 4), 0.7, 1, true, Obstacle.DEFAULT_MASS, ""));
        mends(hanging, "crate", "fix.ground");
    }

    @Test
    void aJourneyWithoutAnActorGetsOne() {
        Scene room = Scenes.room();
        Journey lost = Journey.of("lost", "bob", Place.of(1, 1), Place.of(2, 1));
        mends(NewElements.with(room, lost), "lost", "fix.actor");
        Scene empty = SceneEdits.removed(NewElements.with(room, lost), List.of("ann", "there", "back"));
        mends(empty, "lost", "fix.newactor");
    }

    @Test
    void nothingIsOfferedForAProblemOfTheSceneAsAWhole() {
        assertEquals(List.of(), Fixes.of(Scenes.room(), new Problem(Severity.WARNING, "", 0, "anything", "something")));
    }
}
