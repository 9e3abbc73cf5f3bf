package troupe.unified.manipulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.grid.GridFrame;
import troupe.scene.World;
import troupe.unified.obstacle.Movable;

/**
 * Checks what makes a bound of {@link ExitDistance}: it is 0 wherever nothing is barred, and falls by no more than a move
 * costs. Whatever way leads out, its cost is then no less than the bound where it begins.
 */
class ExitDistancePropertyTest {
    private static final int RANGE = 14;

    @Test
    void isNoughtOutsideAndFallsByNoMoreThanAMoveCosts() {
        for (long seed = 1; seed <= 60; seed++) {
            Random random = new Random(seed);
            World world = new World(3, 2.5 + random.nextDouble(), 0.12 + 0.1 * random.nextDouble());
            double size = 0.2 + 0.4 * random.nextDouble();
            Movable movable = new Movable(
                    0,
                    Plans.solid(Shapes.any(random, 0.8 + random.nextDouble(), 1, size), 0, 1, true),
                    world.cell(),
                    1 + random.nextInt(8));
            ConfigurationSpace barred = new ConfigurationSpace(movable, path(random, world, movable));
            long straight = 1 + random.nextInt(1000);
            long diagonal = 1 + random.nextInt(2000);
            long turn = movable.headings() == 1 ? Prices.BLOCKED : random.nextInt(3000);
            check(
                    "seed " + seed,
                    new ExitDistance(movable, barred, straight, diagonal, turn),
                    new ExitDistance(movable, barred, straight, diagonal, turn),
                    movable.headings(),
                    barred,
                    new long[] {straight, diagonal, turn});
        }
    }

    private static ExpectedPath path(Random random, World world, Movable movable) {
        GridFrame frame = GridFrame.of(world);
        List<Integer> cells = new ArrayList<>();
        int col = frame.colAt(movable.centroid().x());
        int row = frame.rowAt(movable.centroid().y());
        int direction = 0;
        while (cells.size() < 12) {
            cells.add(frame.index(col, row));
            direction = random.nextInt(3) == 0 ? random.nextInt(8) : direction;
            col = Math.max(1, Math.min(frame.cols() - 2, col + GridFrame.dx(direction)));
            row = Math.max(1, Math.min(frame.rows() - 2, row + GridFrame.dy(direction)));
        }
        return Plans.path(frame, cells, 0.1 + 0.2 * random.nextDouble());
    }

    private static void check(
            String name,
            ExitDistance exit,
            ExitDistance unseen,
            int headings,
            ConfigurationSpace barred,
            long[] prices) {
        long most = 0;
        for (int k = 0; k < headings; k++) {
            for (int j = -RANGE; j <= RANGE; j++) {
                for (int i = -RANGE; i <= RANGE; i++) {
                    String at = name + ", pose " + i + ", " + j + ", " + k;
                    long here = exit.of(i, j, k);
                    assertTrue(barred.contains(i, j, k) || here == 0, at);
                    assertTrue(unseen.quick(i, j, k) <= here, at);
                    for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                        long there = exit.of(i + GridFrame.dx(d), j + GridFrame.dy(d), k);
                        assertTrue(here <= prices[d < 4 ? 0 : 1] + there, at);
                    }
                    assertTrue(here <= prices[2] + exit.of(i, j, (k + 1) % headings), at);
                    assertTrue(here <= prices[2] + exit.of(i, j, (k + headings - 1) % headings), at);
                    most = Math.max(most, here);
                }
            }
        }
        assertTrue(most > 0, name);
        assertEquals(0, exit.of(1000, 0, 0), name);
    }
}
