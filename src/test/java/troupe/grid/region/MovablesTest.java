package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.Window;
import troupe.grid.layer.Layers;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

class MovablesTest {
    private static final Actor ACTOR = Actor.standard("a");

    private static Obstacle box(
            double minX, double minY, double maxX, double maxY, double offset, double height, boolean movable) {
        Polygon outline = Polygon.rectangle(minX, minY, maxX, maxY);
        return new Obstacle("o" + minX + minY, "", outline, offset, height, movable, 20, "");
    }

    private static Scene scene(Obstacle... obstacles) {
        return new Scene("", new World(6, 6, 0.1), List.of(obstacles), List.of(), List.of(), List.of());
    }

    @Test
    void nobodyTreadsOnOrStraddlesALowMovable() {
        Region region = Region.of(scene(box(2, 2, 2.98, 3, 0, 0.1, true)), ACTOR);
        int over = region.locate(Place.of(2.55, 2.55));
        assertEquals(0, region.elevation(over), "its top is no floor");
        assertEquals(Kind.STABLE, region.kind(over), "the class does not depend on what can be moved");
        assertFalse(region.open(over));
        assertFalse(region.open(region.locate(Place.of(1.9, 2.55))), "0.05 m from it");
        int beside = region.locate(Place.of(3.15, 2.55));
        assertEquals(Ability.SIDESTEP.bit(), region.abilities(beside) & 3, "0.17 m from it");
        Region onStep = Region.of(scene(box(2, 2, 3, 3, 0, 0.1, false)), ACTOR);
        assertEquals(0.1, onStep.elevation(onStep.locate(Place.of(2.55, 2.55))));
    }

    @Test
    void aMovableUnderAHandThatHangsHighBarsNobody() {
        Region region = Region.of(scene(box(2, 2, 3, 3, 1.8, 0.1, true)), ACTOR);
        assertTrue(region.open(region.locate(Place.of(2.55, 2.55))));
        assertEquals(1, region.spans().sheets());
    }

    @Test
    void patchesKeepSpansAndSayWhereThingsStand() {
        Region region = Region.of(scene(box(2, 2, 3, 3, 0, 2, true), box(4, 4, 5, 5, 0, 2, false)), ACTOR);
        Polygon moved = Polygon.rectangle(0.5, 2, 1.5, 3);
        Region patched = region.with(0, moved);
        assertSame(region.spans(), patched.spans());
        assertEquals(Optional.of(Polygon.rectangle(2, 2, 3, 3)), region.outline(0));
        assertEquals(Optional.of(moved), patched.outline(0));
        assertEquals(Optional.empty(), patched.without(0).outline(0));
        int before = region.locate(Place.of(2.55, 2.55));
        int after = region.locate(Place.of(1, 2.55));
        assertFalse(region.open(before));
        assertTrue(region.open(after));
        assertTrue(patched.open(before));
        assertFalse(patched.open(after));
        assertTrue(patched.without(0).open(after));
        assertThrows(IllegalArgumentException.class, () -> region.with(1, moved));
        assertThrows(IllegalArgumentException.class, () -> region.without(2));
    }

    @Test
    void aMovableIsVaultedOnlyIfItsTopIsInRange() {
        Scene high = scene(box(0, 2.8, 6, 3.1, 0, 0.8, true));
        Region over = Region.of(high, ACTOR);
        int cell = over.frame().cellAt(3.05, 2.95);
        int level = over.level(over.locate(Place.of(3.05, 1)));
        int crossing = over.crossing(cell, level, Kind.JUMPABLE);
        assertTrue(crossing >= over.spanCount());
        assertEquals(cell, over.cell(crossing));
        assertEquals(level, over.level(crossing));
        assertEquals(-1, over.crossing(cell, level, Kind.GAP));
        assertEquals(-1, over.without(0).crossing(cell, level, Kind.JUMPABLE));
        Region low = Region.of(scene(box(0, 2.8, 6, 3.1, 0, 0.2, true)), ACTOR);
        assertEquals(low.spanCount(), low.size(), "what could be stepped on were it fixed");
        Scene both = scene(box(0, 2.8, 6, 3.1, 0, 0.8, false), box(0, 2.6, 6, 2.8, 0, 0.1, true));
        Region barred = Region.of(both, ACTOR);
        assertEquals(-1, barred.crossing(cell, level, Kind.JUMPABLE), "a plank in front of the wall bars the vault");
        assertTrue(barred.without(1).crossing(cell, level, Kind.JUMPABLE) >= 0);
    }

    @Test
    void aMovableThatStandsInADitchBarsTheStrideIfItReachesTheBody() {
        Scene brook = new Scene(
                "",
                new World(6, 6, 0.1),
                List.of(box(2, 2.8, 3, 3.1, -1 + 1, 0.1, true)),
                List.of(new Ditch("d", "", Polygon.rectangle(0, 2.7, 6, 3.2), 1)),
                List.of(),
                List.of());
        Region region = Region.of(brook, ACTOR);
        int level = region.level(region.locate(Place.of(3, 1)));
        int cell = region.frame().cellAt(2.55, 2.95);
        assertEquals(-1, region.crossing(cell, level, Kind.GAP));
        assertTrue(region.without(0).crossing(cell, level, Kind.GAP) >= 0);
        assertTrue(region.crossing(region.frame().cellAt(5.05, 2.95), level, Kind.GAP) >= 0);
    }

    @Test
    void triggersStandRoundACrateInADoorway() {
        Scene room = scene(
                box(0, 3, 2.5, 3.3, 0, 2, false),
                box(3.5, 3, 6, 3.3, 0, 2, false),
                box(2.6, 2.9, 3.4, 3.4, 0, 2, true));
        Region actual = Region.of(room, ACTOR);
        Window whole = new Window(0, 0, actual.frame().cols(), actual.frame().rows());
        int[] points = Triggers.of(actual, actual.without(2), actual, 2, whole).points();
        assertTrue(points.length > 10);
        int[] sorted = points.clone();
        Arrays.sort(sorted);
        assertArrayEquals(sorted, points);
        for (int q : points) {
            assertTrue(actual.open(q) && (actual.abilities(q) & Ability.WALK.bit()) != 0);
            double distance = actual.outline(2).orElseThrow().distance(actual.x(q), actual.y(q));
            assertTrue(distance >= 0.25 && distance < 0.25 + 0.15 * Math.sqrt(2), "distance " + distance);
        }
        assertThrows(IllegalArgumentException.class, () -> Triggers.of(actual, actual.without(2), actual, 0, whole));
    }

    @Test
    void layerOfAnObstacleIsTheOneThatItsBottomRestsOn() {
        Scene scene = scene(
                box(1, 1, 5, 5, 2, 0.2, false),
                box(2, 2, 3, 3, 2.2, 0.5, true),
                box(2, 2, 3, 3, 0, 0.5, true),
                box(4, 4, 4.5, 4.5, 2.2, 0.5, false),
                box(2, 2, 3, 3, 1, 0.5, true));
        RegionBuilder builder = new RegionBuilder(scene, ACTOR.without(Set.of(Ability.VAULT)));
        Layers layers = builder.layers();
        int ground = layers.layer(builder.region().locate(Place.of(0.5, 0.5)));
        int deck = layers.layer(builder.region().locate(Place.of(1.5, 1.5, 2.2)));
        assertEquals(
                List.of(-1, deck, ground, deck, -1),
                scene.obstacles().stream().map(layers::of).toList());
    }
}
