package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

class RegionTest {

    private static Scene scene(World world, Obstacle... obstacles) {
        return new Scene("", world, List.of(obstacles), List.of(), List.of(), List.of());
    }

    private static Obstacle wall(String id, double minX, double minY, double maxX, double maxY) {
        return new Obstacle(id, "", Polygon.rectangle(minX, minY, maxX, maxY), 0, 3, false, 20, "");
    }

    @Test
    void pointActorOnUnitCellsHasExactlyTheFreeCellsOfTheMap() {
        Scene scene = scene(new World(4, 3, 1), wall("a", 1, 1, 2, 3));
        Region region = Region.of(scene, Actor.walker("w", 0, 0));
        StringBuilder map = new StringBuilder();
        for (int row = 3; row >= 1; row--) {
            for (int col = 1; col <= 4; col++) {
                int q = region.frame().index(col, row);
                map.append(region.elevation(q) == 0 && region.open(q) ? '.' : '#');
            }
            map.append('\n');
        }
        assertEquals(".#..\n.#..\n....\n", map.toString());
        int corner = region.locate(Place.of(0.5, 0.5));
        assertEquals(0b11, region.moves(corner), "a diagonal past the wall's corner would cut it");
    }

    @Test
    void sidestepFitsWhereWalkingDoesNot() {
        Scene scene = scene(new World(4, 4, 0.1), wall("a", 0, 1, 1.8, 2), wall("b", 2.2, 1, 4, 2));
        Region region = Region.of(scene, Actor.standard("a"));
        int q = region.locate(Place.of(1.95, 1.55));
        assertEquals(Ability.SIDESTEP.bit(), region.abilities(q) & 3);
        assertEquals(3, region.abilities(region.locate(Place.of(2, 0.5))) & 3);
    }

    @Test
    void flatSceneIsOneSheet() {
        Region region = Region.of(scene(new World(4, 4, 0.1), wall("a", 1, 1, 2, 2)), Actor.standard("a"));
        assertEquals(1, region.spans().sheets());
        assertEquals(Kind.STABLE, region.kind(region.locate(Place.of(0.5, 0.5))));
        assertFalse(region.open(region.locate(Place.of(0.05, 0.5))), "nearer to the world's edge than its radius");
        assertTrue(region.locate(Place.of(5, 5)) < 0);
    }
}
