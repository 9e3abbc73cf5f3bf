package troupe.grid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Compares the disc operators with a kernel that visits every offset, on a plane much wider than the grid. */
class MorphologyOracleTest {
    private static final long SEED = Long.getLong("troupe.seed", 20_252);
    private static final int PAD = 24;

    @Test
    void agreesWithTheNaiveKernelOnRandomMasks() {
        Random random = new Random(SEED);
        for (int round = 0; round < 80; round++) {
            int cols = 1 + random.nextInt(24);
            int rows = 1 + random.nextInt(24);
            double radius = random.nextInt(3) == 0 ? random.nextInt(7) : 7 * random.nextDouble();
            boolean outside = random.nextBoolean();
            byte[] in = DistanceTransformOracleTest.randomMask(random, cols * rows);
            Morphology morphology = new Morphology(cols, rows, round % 2 == 0 ? 7 : 50);
            String message = "seed " + SEED + ", round " + round + ", radius " + radius;
            byte[] out = new byte[cols * rows];
            morphology.dilate(in, radius, outside, out);
            assertArrayEquals(naive(in, cols, rows, radius, outside, 1), out, "dilate, " + message);
            morphology.erode(in, radius, outside, out);
            assertArrayEquals(naive(in, cols, rows, radius, outside, 0), out, "erode, " + message);
            morphology.open(in, radius, outside, out);
            assertArrayEquals(naive(in, cols, rows, radius, outside, 0, 1), out, "open, " + message);
            morphology.close(in, radius, outside, out);
            assertArrayEquals(naive(in, cols, rows, radius, outside, 1, 0), out, "close, " + message);
        }
    }

    /** Rows of bits and sweeps, of which the largest radius decides, agree on grids of several words. */
    @Test
    void bothKernelsAgreeOnWideGrids() {
        Random random = new Random(SEED);
        for (int round = 0; round < 40; round++) {
            int cols = 60 + random.nextInt(140);
            int rows = 1 + random.nextInt(40);
            double radius = 40 * random.nextDouble();
            boolean outside = random.nextBoolean();
            byte[] in = new byte[cols * rows];
            for (int i = 0; i < in.length; i++) {
                in[i] = (byte) (random.nextInt(round + 2) == 0 ? 1 - 2 * random.nextInt(2) : 0);
            }
            byte[] bits = new byte[in.length];
            byte[] swept = new byte[in.length];
            new Morphology(cols, rows, 40).open(in, radius, outside, bits);
            new Morphology(cols, rows, 60).open(in, radius, outside, swept);
            assertArrayEquals(swept, bits, "open, seed " + SEED + ", round " + round + ", radius " + radius);
            new Morphology(cols, rows, 40).close(in, radius, outside, bits);
            new Morphology(cols, rows, 60).close(in, radius, outside, swept);
            assertArrayEquals(swept, bits, "close, seed " + SEED + ", round " + round + ", radius " + radius);
        }
    }

    /** An opening by a disc of radius 2 keeps a 5 x 5 block without its corners and drops a 3-wide bar. */
    @Test
    void openingKeepsWhatTheDiscCovers() {
        byte[] in = mask(
                "............", //
                ".#####......",
                ".#####.####.",
                ".#####.####.",
                ".#####.####.",
                ".#####......",
                "............");
        byte[] out = new byte[in.length];
        new Morphology(12, 7, 2).open(in, 2, false, out);
        assertArrayEquals(
                mask(
                        "............", //
                        "...#........",
                        "..###.......",
                        ".#####......",
                        "..###.......",
                        "...#........",
                        "............"),
                out);
    }

    @Test
    void inputMayBeTheOutput() {
        byte[] in = mask("..#..", "#....", "....#");
        byte[] expected = new byte[in.length];
        new Morphology(5, 3, 2).dilate(in, 1, false, expected);
        new Morphology(5, 3, 2).dilate(in, 1, false, in);
        assertArrayEquals(expected, in);
    }

    @Test
    void rejectsRadiiThatItWasNotMadeFor() {
        Morphology morphology = new Morphology(3, 3, 2);
        byte[] in = new byte[9];
        assertThrows(IllegalArgumentException.class, () -> morphology.dilate(in, 3, false, in));
        assertThrows(IllegalArgumentException.class, () -> morphology.dilate(in, Double.NaN, false, in));
        assertThrows(IllegalArgumentException.class, () -> new Morphology(3, 3, -1));
    }

    private static byte[] mask(String... rows) {
        byte[] mask = new byte[rows.length * rows[0].length()];
        for (int i = 0; i < mask.length; i++) {
            mask[i] = (byte) (rows[i / rows[0].length()].charAt(i % rows[0].length()) == '#' ? 1 : 0);
        }
        return mask;
    }

    /** Grows the given values one after the other by visiting every offset of the disc. */
    private static byte[] naive(byte[] in, int cols, int rows, double radius, boolean outside, int... values) {
        int width = cols + 2 * PAD;
        int height = rows + 2 * PAD;
        byte[] plane = new byte[width * height];
        for (int i = 0; i < plane.length; i++) {
            int x = i % width - PAD;
            int y = i / width - PAD;
            boolean inside = x >= 0 && y >= 0 && x < cols && y < rows;
            plane[i] = (byte) ((inside ? in[y * cols + x] != 0 : outside) ? 1 : 0);
        }
        for (int value : values) {
            plane = grow(plane, width, height, radius, (byte) value);
        }
        byte[] out = new byte[cols * rows];
        for (int row = 0; row < rows; row++) {
            System.arraycopy(plane, (row + PAD) * width + PAD, out, row * cols, cols);
        }
        return out;
    }

    private static byte[] grow(byte[] plane, int width, int height, double radius, byte value) {
        byte[] result = plane.clone();
        int reach = (int) Math.ceil(radius);
        for (int i = 0; i < plane.length; i++) {
            if (plane[i] != value) {
                continue;
            }
            for (int dy = -reach; dy <= reach; dy++) {
                for (int dx = -reach; dx <= reach; dx++) {
                    int x = i % width + dx;
                    int y = i / width + dy;
                    if (dx * dx + dy * dy <= radius * radius && x >= 0 && y >= 0 && x < width && y < height) {
                        result[y * width + x] = value;
                    }
                }
            }
        }
        return result;
    }
}
