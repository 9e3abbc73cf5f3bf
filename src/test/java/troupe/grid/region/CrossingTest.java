package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

class CrossingTest {
    private static final World WORLD = new World(6, 4, 0.1);
    private static final Actor ACTOR = Actor.standard("a");

    private static Scene scene(List<Obstacle> obstacles, Ditch... ditches) {
        return new Scene("", WORLD, obstacles, List.of(ditches), List.of(), List.of());
    }

    private static Obstacle block(double minX, double minY, double maxX, double maxY, double offset, double height) {
        String id = "o" + minX + "-" + minY + "-" + offset;
        return new Obstacle(id, "", Polygon.rectangle(minX, minY, maxX, maxY), offset, height, false, 20, "");
    }

    private static int crossings(Region region, byte kind) {
        int count = 0;
        for (int q = region.spanCount(); q < region.size(); q++) {
            count += region.kind(q) == kind ? 1 : 0;
        }
        return count;
    }

    @Test
    void ditchNarrowerThanTheGaitIsAGap() {
        Scene scene = scene(List.of(), new Ditch("d", "", Polygon.rectangle(2.5, 0, 3.1, 4), 1));
        Region region = Region.of(scene, ACTOR);
        assertTrue(crossings(region, Kind.GAP) > 0);
        int left = region.locate(Place.of(2.35, 2.05));
        int right = region.locate(Place.of(3.25, 2.05));
        assertTrue(region.straight(left, right, Kind.GAP), "0.9 m between the two centres");
        assertFalse(region.straight(left, region.locate(Place.of(3.35, 2.05)), Kind.GAP), "1 m is more than the gait");
        assertFalse(region.straight(left, right, Kind.JUMPABLE));
        assertEquals(Kind.FORBIDDEN, region.kind(region.locate(Place.of(2.45, 2.05))), "the foot hangs over");
        assertEquals(0, crossings(Region.of(scene, ACTOR.without(Set.of(Ability.STRIDE))), Kind.GAP));
    }

    @Test
    void ditchWiderThanTheGaitIsNone() {
        Scene scene = scene(List.of(), new Ditch("d", "", Polygon.rectangle(2.5, 0, 3.3, 4), 1));
        assertEquals(0, crossings(Region.of(scene, ACTOR), Kind.GAP));
    }

    @Test
    void lowWallIsVaultedWithinReach() {
        Region region = Region.of(scene(List.of(block(2.52, 0, 2.78, 4, 0, 0.9))), ACTOR);
        assertTrue(crossings(region, Kind.JUMPABLE) > 0);
        int left = region.locate(Place.of(2.25, 2.05));
        int right = region.locate(Place.of(3.05, 2.05));
        assertTrue(region.straight(left, right, Kind.JUMPABLE));
        assertFalse(
                region.straight(region.locate(Place.of(2.15, 2.05)), right, Kind.JUMPABLE), "walks before it vaults");
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int edge = region.locate(Place.of(2.25, 2.05));
        assertFalse(region.plain(edge));
        int n = region.neighbours(edge, targets, directions);
        assertEquals(11, n, "eight places beside the wall, three of them to the east also crossings");
        assertEquals(edge + 1, targets[0], "where one can still sidestep");
        assertEquals(Kind.JUMPABLE, region.kind(targets[1]));
        assertEquals(0, directions[1]);
        assertEquals(Ability.VAULT.bit(), region.abilities(targets[1]));
        assertEquals(edge + 1, region.cell(targets[1]));
    }

    @Test
    void wallHigherThanItsRangeOrUnderABeamIsNotVaulted() {
        assertEquals(0, crossings(Region.of(scene(List.of(block(2.5, 0, 2.8, 4, 0, 1.2))), ACTOR), Kind.JUMPABLE));
        Scene beam = scene(List.of(block(2.5, 0, 2.8, 4, 0, 0.9), block(2, 0, 4, 4, 2.0, 0.3)));
        assertEquals(0, crossings(Region.of(beam, ACTOR), Kind.JUMPABLE), "needs 0.9 + 1.2 m under the beam");
        Scene high = scene(List.of(block(2.5, 0, 2.8, 4, 0, 0.9), block(2, 0, 4, 4, 2.1, 0.3)));
        assertTrue(crossings(Region.of(high, ACTOR), Kind.JUMPABLE) > 0);
    }

    @Test
    void longLowTableFromWallToWallIsTooThickToVault() {
        Scene thick = scene(List.of(block(0, 1, 6, 3, 0, 0.8)));
        assertEquals(0, crossings(Region.of(thick, ACTOR), Kind.JUMPABLE));
    }
}
