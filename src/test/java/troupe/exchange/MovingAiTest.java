package troupe.exchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.MovingAiProblems;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Reads maps and problems: whole ones, wrong ones and ten thousand damaged ones. */
class MovingAiTest {
    private static final String SMALL = "type octile\nheight 3\nwidth 4\nmap\n.@@.\n.@@G\nTSWO\n";

    private static MovingAiMap map(String text) throws IOException, ExchangeException {
        return MovingAiMap.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.ISO_8859_1)), "small.map");
    }

    private static List<MovingAiProblems.Problem> problems(String text) throws IOException, ExchangeException {
        return MovingAiProblems.read(
                new ByteArrayInputStream(text.getBytes(StandardCharsets.ISO_8859_1)), "small.scen");
    }

    @Test
    void readsCellsWithTheFirstRowOnTop() throws Exception {
        MovingAiMap map = map(SMALL);
        assertEquals(4, map.width());
        assertEquals(3, map.height());
        assertFalse(map.blocked(0, 0));
        assertTrue(map.blocked(1, 0));
        assertFalse(map.blocked(3, 1), "G is free");
        assertTrue(map.blocked(0, 2), "T is blocked");
        assertFalse(map.blocked(1, 2), "S is free");
        assertTrue(map.blocked(2, 2), "W is blocked");
        assertEquals(Place.of(1.5, 0.5), map.place(1, 2));
    }

    @Test
    void joinsBlockedCellsToRectangles() throws Exception {
        Scene scene = map(SMALL).scene();
        List<Polygon> outlines =
                scene.obstacles().stream().map(Obstacle::outline).toList();
        assertEquals(
                List.of(Polygon.rectangle(1, 1, 3, 3), Polygon.rectangle(0, 0, 1, 1), Polygon.rectangle(2, 0, 4, 1)),
                outlines);
        assertEquals(0, scene.actors().get(0).walk().radius());
        assertEquals(0, scene.actors().get(0).footRadius());
        assertEquals(1, scene.world().cell());
    }

    @Test
    void wallsOfTheSceneCoverExactlyTheBlockedCells() throws Exception {
        Random random = new Random(7);
        for (int round = 0; round < 200; round++) {
            MovingAiMap map = map(randomMap(random, 1 + random.nextInt(12), 1 + random.nextInt(12)));
            Scene scene = map.scene();
            GridFrame frame = GridFrame.of(scene.world());
            int[] covers = new int[frame.size()];
            for (Obstacle wall : scene.obstacles()) {
                for (int i = 0; i < covers.length; i++) {
                    covers[i] +=
                            wall.outline().contains(frame.centreX(frame.col(i)), frame.centreY(frame.row(i))) ? 1 : 0;
                }
            }
            for (int y = 0; y < map.height(); y++) {
                for (int x = 0; x < map.width(); x++) {
                    Place place = map.place(x, y);
                    assertEquals(map.blocked(x, y) ? 1 : 0, covers[frame.cellAt(place.x(), place.y())]);
                }
            }
        }
    }

    private static String randomMap(Random random, int width, int height) {
        StringBuilder text = new StringBuilder("type octile\nheight " + height + "\nwidth " + width + "\nmap\n");
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                text.append("..G@TW".charAt(random.nextInt(6)));
            }
            text.append('\n');
        }
        return text.toString();
    }

    @Test
    void takesCarriageReturnsAndEitherOrderOfTheSizes() throws Exception {
        MovingAiMap map = map("type octile\r\nwidth 2\r\nheight 1\r\nmap\r\n.@\r\n\r\n");
        assertEquals(2, map.width());
        assertTrue(map.blocked(1, 0));
    }

    @Test
    void saysInOneLineWhereAMapIsWrongAndWhatToDo() {
        assertMessage(
                "small.map:5:3: found 'x'; a cell is one of . G S (free) @ T O W (blocked)",
                SMALL.replace(".@@.", ".@x."));
        assertMessage("small.map:6: a row of 3 cells; give 4, as the width says", SMALL.replace(".@@G", ".@@"));
        assertMessage("small.map:6: ends before row 3 of 3; give the whole file", SMALL.replace("TSWO\n", ""));
        assertMessage("small.map:8:1: the line does not belong here; end the map after 3 rows", SMALL + "....\n");
        assertMessage(
                "small.map:3: width is '99999'; give a whole number from 1 to 65536",
                SMALL.replace("width 4", "width 99999"));
        assertMessage(
                "small.map:4: a map of 60000 x 60000 cells; give width and height with at most 16777216 cells in all",
                "type octile\nheight 60000\nwidth 60000\nmap\n");
    }

    private static void assertMessage(String message, String text) {
        assertEquals(
                message, assertThrows(ExchangeException.class, () -> map(text)).getMessage());
    }

    @Test
    void readsProblemsInTabsAndInBlanks() throws Exception {
        List<MovingAiProblems.Problem> all = problems("version 1.0\n"
                + "31 maps/bg/AR 7.map 4 3 0 0 3 1 12.04\n"
                + "0\tsmall.map\t4\t3\t0\t0\t3\t1\t3.41421356\n\n");
        assertEquals(2, all.size());
        assertEquals("AR 7.map", all.get(0).mapName());
        assertEquals(31, all.get(0).bucket());
        assertEquals(12.04, all.get(0).length());
        assertEquals(Place.of(0.5, 2.5), all.get(1).start());
        assertEquals(Place.of(3.5, 1.5), all.get(1).goal());
    }

    @Test
    void saysWhatIsWrongWithAProblem() {
        String good = "version 1\n0\tsmall.map\t4\t3\t0\t0\t3\t1\t3.4\n";
        assertEquals(
                "small.scen:2: goalX is '4'; give a whole number from 0 to 3",
                assertThrows(ExchangeException.class, () -> problems(good.replace("\t3\t1\t3.4", "\t4\t1\t3.4")))
                        .getMessage());
        assertEquals(
                "small.scen:2: length is 'NaN'; give a number from 0",
                assertThrows(ExchangeException.class, () -> problems(good.replace("3.4", "NaN")))
                        .getMessage());
        assertThrows(ExchangeException.class, () -> problems("version 2\n"));
        assertThrows(ExchangeException.class, () -> problems("version 1\n0 small.map 4 3\n"));
    }

    @Test
    void tenThousandDamagedMapsGiveOnlyTheDeclaredException() throws IOException {
        long seed = Long.getLong("troupe.seed", 20_090_701L);
        Random random = new Random(seed);
        byte[] map = randomMap(random, 24, 16).getBytes(StandardCharsets.ISO_8859_1);
        byte[] scen = "version 1\n0\tsmall.map\t24\t16\t0\t0\t3\t1\t3.41421356\n1\ta.map\t24\t16\t5\t6\t3\t1\t5.5\n"
                .getBytes(StandardCharsets.ISO_8859_1);
        int refused = 0;
        for (int round = 0; round < 10_000; round++) {
            try {
                MovingAiMap.read(new ByteArrayInputStream(Damage.done(map, random)), "bad.map")
                        .scene();
            } catch (ExchangeException e) {
                assertFalse(e.getMessage().contains("\n"), () -> "seed " + seed + ": " + e.getMessage());
                refused++;
            }
            try {
                MovingAiProblems.read(new ByteArrayInputStream(Damage.done(scen, random)), "bad.scen");
            } catch (ExchangeException e) {
                assertFalse(e.getMessage().contains("\n"), () -> "seed " + seed + ": " + e.getMessage());
            }
        }
        assertTrue(refused > 5_000, "only " + refused + " of 10000 refused, seed " + seed);
    }
}
