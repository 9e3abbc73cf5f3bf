package troupe.exchange.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.World;

class WalkableAreaTest {
    private static final long SEED = Long.getLong("seed", 77);
    private static final World WORLD = new World(10, 8, 0.1);

    private static double area(WalkableArea ground) {
        return ground.outline().signedArea()
                + ground.holes().stream().mapToDouble(Polygon::signedArea).sum();
    }

    private static boolean contains(WalkableArea ground, double x, double y) {
        return ground.outline().contains(x, y) && ground.holes().stream().noneMatch(h -> h.contains(x, y));
    }

    @Test
    void whatOverlapsBecomesOneHole() {
        List<Polygon> blocks = List.of(Polygon.rectangle(2, 2, 4, 4), Polygon.rectangle(3, 3, 5, 5));
        WalkableArea ground = WalkableArea.of(WORLD, blocks, List.of(new double[] {1, 1}));
        assertEquals(1, ground.holes().size());
        assertEquals(80 - 7, area(ground), 1e-9);
        assertEquals(0, ground.leftOut());
        assertEquals(0, ground.outside());
    }

    @Test
    void anIslandInTheMiddleIsAHoleThoughTheMiddleOfTheOutlineLiesInIt() {
        WalkableArea ground =
                WalkableArea.of(WORLD, List.of(Polygon.rectangle(3, 2, 7, 6)), List.of(new double[] {1, 1}));
        assertEquals(1, ground.holes().size());
        assertEquals(64, area(ground), 1e-9);
    }

    @Test
    void thePartThatHoldsThePeopleIsKeptAndTheRestTold() {
        List<Polygon> wall = List.of(Polygon.rectangle(6, -1, 6.5, 9));
        WalkableArea ground =
                WalkableArea.of(WORLD, wall, List.of(new double[] {8, 1}, new double[] {9, 1}, new double[] {1, 1}));
        assertEquals(28, area(ground), 1e-9);
        assertEquals(48, ground.leftOut(), 1e-9);
        assertEquals(1, ground.outside());
    }

    @Test
    void blocksThatTouchInACornerGiveHolesThatDoNotTouchThemselves() {
        List<Polygon> blocks =
                List.of(Polygon.rectangle(2, 2, 3, 3), Polygon.rectangle(3, 3, 4, 4), Polygon.rectangle(8, 7, 9, 8));
        WalkableArea ground = WalkableArea.of(WORLD, blocks, List.of());
        assertEquals(80 - 3, area(ground), 1e-9);
        for (Polygon hole : ground.holes()) {
            assertEquals(
                    hole.size(),
                    java.util.stream.IntStream.range(0, hole.size())
                            .mapToObj(i -> hole.x(i) + " " + hole.y(i))
                            .distinct()
                            .count());
        }
    }

    @Test
    void nothingLeftIsAMistake() {
        List<Polygon> all = List.of(Polygon.rectangle(-1, -1, 11, 9));
        assertThrows(IllegalArgumentException.class, () -> WalkableArea.of(WORLD, all, List.of()));
    }

    @Test
    void aPointIsOnTheGroundOnlyIfNoBlockHoldsIt() {
        SplittableRandom random = new SplittableRandom(SEED);
        int seen = 0;
        for (int trial = 0; trial < 150; trial++) {
            List<Polygon> blocks = new ArrayList<>();
            for (int k = 1 + random.nextInt(9); k > 0; k--) {
                blocks.add(triangle(random));
            }
            double[] person = {random.nextDouble(10), random.nextDouble(8)};
            if (blocks.stream().anyMatch(b -> b.contains(person[0], person[1]))) {
                continue;
            }
            WalkableArea ground = WalkableArea.of(WORLD, blocks, List.of(person));
            double free = 0;
            for (int k = 0; k < 400; k++) {
                double x = 10 * (k % 20 + 0.5) / 20 + 1e-4 * random.nextDouble();
                double y = 8 * (k / 20 + 0.5) / 20 + 1e-4 * random.nextDouble();
                boolean blocked = blocks.stream().anyMatch(b -> b.contains(x, y));
                boolean on = contains(ground, x, y);
                assertTrue(!(on && blocked), "seed " + SEED + ", trial " + trial + " at " + x + "," + y);
                free += blocked ? 0 : 80.0 / 400;
                seen += on ? 1 : 0;
            }
            assertTrue(contains(ground, person[0], person[1]), "seed " + SEED + ", trial " + trial);
            assertEquals(free, area(ground) + ground.leftOut(), 6, "seed " + SEED + ", trial " + trial);
        }
        assertTrue(seen > 1_000, seen + " points on the ground");
    }

    private static Polygon triangle(SplittableRandom random) {
        // corners on a coarse grid, so that edges and corners meet often
        double[] xs = new double[3];
        double[] ys = new double[3];
        for (int i = 0; i < 3; i++) {
            xs[i] = random.nextInt(11);
            ys[i] = random.nextInt(9);
        }
        return new Polygon(xs, ys);
    }
}
