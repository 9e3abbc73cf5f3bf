package troupe.grid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Compares the distance transform with the nearest source found by trying them all. */
class DistanceTransformOracleTest {
    private static final long SEED = Long.getLong("troupe.seed", 20_251);

    @Test
    void agreesWithBruteForceOnRandomMasks() {
        Random random = new Random(SEED);
        for (int round = 0; round < 120; round++) {
            int cols = 1 + random.nextInt(40);
            int rows = 1 + random.nextInt(40);
            byte[] sources = randomMask(random, cols * rows);
            int[] squared = new int[cols * rows];
            new DistanceTransform(cols, rows).compute(sources, squared);
            assertArrayEquals(
                    brute(sources, cols, 0, 0, cols, rows, new int[cols * rows]),
                    squared,
                    "seed " + SEED + ", round " + round);
        }
    }

    @Test
    void boxSeesOnlyItsOwnSourcesAndWritesNothingElse() {
        Random random = new Random(SEED);
        for (int round = 0; round < 120; round++) {
            int cols = 2 + random.nextInt(30);
            int rows = 2 + random.nextInt(30);
            int col0 = random.nextInt(cols);
            int row0 = random.nextInt(rows);
            int col1 = col0 + random.nextInt(cols - col0 + 1);
            int row1 = row0 + random.nextInt(rows - row0 + 1);
            byte[] sources = randomMask(random, cols * rows);
            int[] expected = new int[cols * rows];
            Arrays.fill(expected, -7);
            int[] squared = expected.clone();
            new DistanceTransform(cols, rows).compute(sources, squared, col0, row0, col1, row1);
            brute(sources, cols, col0, row0, col1, row1, expected);
            assertArrayEquals(expected, squared, "seed " + SEED + ", round " + round);
        }
    }

    @Test
    void squaredDistancesOfTheLargestSideStayInRange() {
        int side = 2_000;
        byte[] sources = new byte[side * side];
        sources[0] = 1;
        int[] squared = new int[side * side];
        new DistanceTransform(side, side).compute(sources, squared);
        assertEquals(2 * 1_999 * 1_999, squared[side * side - 1]);
    }

    @Test
    void rejectsBoxesOutsideTheGrid() {
        DistanceTransform transform = new DistanceTransform(4, 3);
        byte[] sources = new byte[12];
        int[] squared = new int[12];
        assertThrows(IllegalArgumentException.class, () -> transform.compute(sources, squared, 0, 0, 5, 3));
        assertThrows(IllegalArgumentException.class, () -> transform.compute(sources, squared, 3, 0, 2, 3));
        assertThrows(IllegalArgumentException.class, () -> new DistanceTransform(0, 3));
    }

    static byte[] randomMask(Random random, int size) {
        byte[] mask = new byte[size];
        double density = Math.pow(random.nextDouble(), 3);
        for (int i = 0; i < size; i++) {
            mask[i] = (byte) (random.nextDouble() < density ? 1 + random.nextInt(5) : 0);
        }
        return mask;
    }

    private static int[] brute(byte[] sources, int cols, int col0, int row0, int col1, int row1, int[] squared) {
        for (int row = row0; row < row1; row++) {
            for (int col = col0; col < col1; col++) {
                int best = DistanceTransform.NONE;
                for (int r = row0; r < row1; r++) {
                    for (int c = col0; c < col1; c++) {
                        if (sources[r * cols + c] != 0) {
                            best = Math.min(best, (r - row) * (r - row) + (c - col) * (c - col));
                        }
                    }
                }
                squared[row * cols + col] = best;
            }
        }
        return squared;
    }
}
