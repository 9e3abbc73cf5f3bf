package troupe.app.property;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Scene;

/** Reads and changes properties of a small room. */
class PropertiesTest {
    private final Scene scene = Scenes.room();

    private static Property property(Scene scene, String key, String... ids) {
        return Properties.of(scene, List.of(ids)).stream()
                .flatMap(g -> g.properties().stream())
                .filter(p -> p.key().equals(key))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no property " + key));
    }

    private Scene with(String key, String text, String... ids) {
        return property(scene, key, ids).with(scene, List.of(ids), text);
    }

    private static List<String> keys(Scene scene, String... ids) {
        return Properties.of(scene, List.of(ids)).stream()
                .flatMap(g -> g.properties().stream())
                .map(Property::key)
                .toList();
    }

    @Test
    void severalShowWhatTheyHaveInCommonAndChangeTogether() {
        List<String> ids = List.of("crate", "post");
        Property height = property(scene, "height", "crate", "post");
        assertEquals(Optional.of("1.00"), height.common(scene, ids));
        assertEquals(Optional.of(""), property(scene, "x", "crate", "post").common(scene, ids));
        Scene higher = height.with(scene, ids, "2.5");
        assertEquals(2.5, higher.obstacle("crate").orElseThrow().height());
        assertEquals(2.5, higher.obstacle("post").orElseThrow().height());
        assertTrue(keys(scene, "crate", "ditch").contains("turn"));
        assertTrue(!keys(scene, "crate", "ditch").contains("height"));
    }

    @Test
    void whatCannotBeTakenIsToldWithTheReason() {
        Property height = property(scene, "height", "crate");
        assertTrue(height.wrong(scene, List.of("crate"), "-1").isPresent());
        assertTrue(height.wrong(scene, List.of("crate"), "high").isPresent());
        assertEquals(Optional.empty(), height.wrong(scene, List.of("crate"), "1,5"));
        Property ordering = property(scene, "setting.ordering", "there");
        assertTrue(ordering.wrong(scene, List.of("there"), "best").orElseThrow().contains("optimal"));
    }

    @Test
    void sizesKeepTheMiddle() {
        assertEquals(
                Polygon.rectangle(3.5, 3, 5.5, 4),
                with("width", "2", "crate").obstacle("crate").orElseThrow().outline());
        assertEquals(
                Polygon.rectangle(4, 2.5, 5, 4.5),
                with("across", "2", "crate").obstacle("crate").orElseThrow().outline());
    }

    @Test
    void aJourneyMayBeginOnAnUpperFloor() {
        Journey high = (Journey) with("start.z", "2.6", "there").task("there").orElseThrow();
        assertEquals(OptionalDouble.of(2.6), high.start().z());
        Scene raised = scene.with(high);
        Journey low = (Journey) property(raised, "start.z", "there")
                .with(raised, List.of("there"), "")
                .task("there")
                .orElseThrow();
        assertEquals(OptionalDouble.empty(), low.start().z());
    }

    @Test
    void anActorLosesAndGetsAbilities() {
        Scene without = with("has.vault", "false", "ann");
        assertEquals(Optional.empty(), without.actor("ann").orElseThrow().vault());
        assertTrue(!keys(without, "ann").contains("setting.vault.reach"));
        Scene again = property(without, "has.vault", "ann").with(without, List.of("ann"), "true");
        assertEquals(
                Optional.of(Actor.Vault.DEFAULT),
                again.actor("ann").orElseThrow().vault());
        Scene slow = with("setting.walk.speed", "0.8", "ann");
        assertEquals(0.8, slow.actor("ann").orElseThrow().walk().speed());
        assertEquals(scene.tasks(), slow.tasks());
    }

    @Test
    void theWorldKeepsItsCellsPerSide() {
        Scene wide = property(scene, "world.width").writing().with(scene, "", "20");
        assertEquals(20, wide.world().width());
        assertEquals(0.1, wide.world().cell());
        assertEquals(
                "Hall",
                property(scene, "title").writing().with(scene, "", "Hall").title());
    }
}
