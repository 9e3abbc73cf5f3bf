package troupe.grid.field;

import java.util.Random;
import troupe.grid.region.StepRelation;

/** Makes random flat masks of several kinds: noise, caves, rooms with blocks, discs; the border is closed. */
final class RandomMasks {
    private RandomMasks() {}

    static MaskSteps next(Random random, int largest) {
        int cols = 5 + random.nextInt(largest - 4);
        int rows = 5 + random.nextInt(largest - 4);
        boolean[] open = new boolean[cols * rows];
        int kind = random.nextInt(3);
        double density = random.nextDouble();
        for (int q = 0; q < open.length; q++) {
            open[q] = kind != 0 || random.nextDouble() < 0.4 + 0.6 * density;
        }
        for (int k = random.nextInt(1 + open.length / 60); kind != 0 && k > 0; k--) {
            double x = random.nextDouble() * cols;
            double y = random.nextDouble() * rows;
            double half = 0.5 + random.nextDouble() * largest / 8;
            double other = kind == 1 ? half : 0.5 + random.nextDouble() * largest / 8;
            double turn = random.nextInt(2) * random.nextDouble() * 3;
            cut(open, cols, x, y, half, other, turn, kind == 1);
        }
        for (int q = 0; q < open.length; q++) {
            int col = q % cols;
            int row = q / cols;
            open[q] &= col > 0 && row > 0 && col < cols - 1 && row < rows - 1;
        }
        return new MaskSteps(open, cols, 0.1);
    }

    private static void cut(
            boolean[] open, int cols, double x, double y, double half, double other, double turn, boolean disc) {
        for (int q = 0; q < open.length; q++) {
            double dx = q % cols - x;
            double dy = (double) (q / cols) - y;
            double u = dx * Math.cos(turn) + dy * Math.sin(turn);
            double v = dy * Math.cos(turn) - dx * Math.sin(turn);
            boolean inside = disc ? Math.hypot(dx, dy) < half : Math.abs(u) < half && Math.abs(v) < other;
            open[q] &= !inside;
        }
    }

    /** Returns a random open node, -1 if there is none. */
    static int place(Random random, StepRelation steps) {
        for (int tries = 0; tries < 1_000; tries++) {
            int q = random.nextInt(steps.size());
            if (steps.open(q)) {
                return q;
            }
        }
        return -1;
    }
}
