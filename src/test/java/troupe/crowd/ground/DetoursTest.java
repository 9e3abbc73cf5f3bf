package troupe.crowd.ground;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

class DetoursTest {
    private static final Place GOAL = Place.of(10, 5);

    private static Terrain terrain() {
        CrowdGroup group = CrowdGroup.of("all", GOAL, CrowdGroup.Members.of(3, Polygon.rectangle(1, 1, 3, 9)));
        Crowd crowd = Crowd.of("crowd", List.of(group));
        Scene scene = new Scene("", new World(12, 10, 0.1), List.of(), List.of(), List.of(), List.of(crowd));
        return new Ground(scene, crowd).terrain(0.2);
    }

    private static float[] found(Terrain terrain, long slice) {
        Detours detours = new Detours(terrain);
        // slow ground in the lower half
        detours.begin(terrain.region().locate(GOAL), (x, y, z) -> y < 4 ? 3 : 1);
        while (!detours.advance(slice)) {
            // the next slice
        }
        return detours.found().clone();
    }

    @Test
    void slicedEqualsWhole() {
        Terrain terrain = terrain();
        float[] whole = found(terrain, Long.MAX_VALUE);
        for (long slice : new long[] {1, 7, 1_000}) {
            assertArrayEquals(whole, found(terrain, slice), "slices of " + slice);
        }
    }

    @Test
    void slowGroundCostsAsManyTimesMore() {
        Terrain terrain = terrain();
        float[] whole = found(terrain, Long.MAX_VALUE);
        assertEquals(0, whole[terrain.region().locate(GOAL)]);
        double fast = whole[terrain.region().locate(Place.of(6, 5))];
        assertEquals(4, fast, 0.11);
        int from = terrain.region().locate(Place.of(6, 2));
        int to = terrain.region().locate(Place.of(6, 3));
        // one metre up through slow ground, seen in the difference of the two potentials
        assertTrue(whole[from] - whole[to] > 2, whole[from] + " - " + whole[to]);
    }
}
