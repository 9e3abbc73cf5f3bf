package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import troupe.SharedData;
import troupe.exchange.scenario.MovingAiMap;
import troupe.scene.Scene;

/** Builds the regions of published maps, whose cells a point actor must have exactly. */
class MapRegionTest {

    @ParameterizedTest
    @ValueSource(strings = {"arena2.map", "ht_chantry.map", "Berlin_0_256.map", "32room_000.map"})
    void pointActorHasExactlyTheCellsOfTheMap(String name) throws Exception {
        Path file = SharedData.require("movingai/" + name);
        MovingAiMap map = MovingAiMap.read(file);
        Scene scene = map.scene();
        Region region = Region.of(scene, scene.actor(MovingAiMap.ACTOR).orElseThrow());
        int wrong = 0;
        for (int y = 0; y < map.height(); y++) {
            for (int x = 0; x < map.width(); x++) {
                int q = region.locate(map.place(x, y));
                boolean free = q >= 0 && region.open(q) && region.elevation(q) == 0;
                wrong += free == map.blocked(x, y) ? 1 : 0;
            }
        }
        assertEquals(0, wrong, name);
    }
}
