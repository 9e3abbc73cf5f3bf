package troupe.exchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import troupe.SharedData;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.MovingAiProblems;
import troupe.geometry.Box;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Reads the published maps and problems. */
class MovingAiDataTest {

    @ParameterizedTest
    @CsvSource({
        "arena2, 281, 209, 929",
        "AR0072SR, 512, 512, 1280",
        "ht_chantry, 162, 141, 470",
        "32room_000, 512, 512, 1900",
        "maze512-32-0, 512, 512, 5760",
        "Berlin_0_256, 256, 256, 930"
    })
    void mapsAndProblemsAreReadWhole(String name, int width, int height, int count) throws Exception {
        Path file = SharedData.require("movingai/" + name + ".map");
        MovingAiMap map = MovingAiMap.read(file);
        assertEquals(width, map.width());
        assertEquals(height, map.height());
        List<String> rows = Files.readAllLines(file).subList(4, 4 + height);
        BitSet covered = covered(map.scene(), width);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                boolean free = rows.get(y).charAt(x) == '.';
                assertEquals(free, !map.blocked(x, y), "cell " + x + "," + y);
                assertEquals(free, !covered.get((height - 1 - y) * width + x), "scene at " + x + "," + y);
            }
        }
        List<MovingAiProblems.Problem> problems =
                MovingAiProblems.read(SharedData.require("movingai/" + name + ".map.scen"));
        assertEquals(count, problems.size());
        for (MovingAiProblems.Problem p : problems) {
            assertEquals(name + ".map", p.mapName());
            assertEquals(width, p.width());
            assertEquals(height, p.height());
            assertFalse(map.blocked(p.startX(), p.startY()), p.toString());
            assertFalse(map.blocked(p.goalX(), p.goalY()), p.toString());
            assertEquals(map.place(p.startX(), p.startY()), p.start());
            assertEquals(map.place(p.goalX(), p.goalY()), p.goal());
            int dx = Math.abs(p.startX() - p.goalX());
            int dy = Math.abs(p.startY() - p.goalY());
            double least = Math.max(dx, dy) + (Math.sqrt(2) - 1) * Math.min(dx, dy);
            assertTrue(p.length() >= least - 0.01 - 1e-5 * least, p.toString());
        }
    }

    /** Returns the cells that walls cover, from the bottom left; a cell covered twice fails. */
    private static BitSet covered(Scene scene, int width) {
        BitSet covered = new BitSet();
        for (Obstacle wall : scene.obstacles()) {
            Box box = wall.outline().bounds();
            for (int y = (int) box.minY(); y < box.maxY(); y++) {
                for (int x = (int) box.minX(); x < box.maxX(); x++) {
                    assertFalse(covered.get(y * width + x), "covered twice");
                    covered.set(y * width + x);
                }
            }
        }
        return covered;
    }
}
