package troupe.grid.field;

import java.util.Arrays;
import troupe.grid.region.Region;
import troupe.grid.region.StepRelation;

/**
 * Computes the NF1 potential: the length of the shortest way to the goal in waves, breadth-first over the
 * legal steps of a region, in metres. Its only local minimum is the goal, but it grazes obstacles.
 *
 * <p>Source: Latombe, <em>Robot Motion Planning</em>, chapter 7; Barraquand, Langlois &amp; Latombe 1992.
 */
public final class Nf1 {
    /** The potential of places from which no legal way leads to the goal. */
    public static final float UNREACHABLE = Float.POSITIVE_INFINITY;

    private Nf1() {}

    /**
     * Computes the potential over all eight directions.
     *
     * @param goal an open configuration
     * @return metres per configuration, waves times the cell; 0 at the goal, {@link #UNREACHABLE} elsewhere
     * @throws IllegalArgumentException if the goal is not open
     */
    public static float[] compute(Region region, int goal) {
        return compute(region, goal, true);
    }

    /**
     * Computes the potential over eight directions, or over the four straight ones only.
     *
     * @param diagonals whether a wave also takes diagonal steps; each counts as one
     * @throws IllegalArgumentException if the goal is not open
     */
    public static float[] compute(Region region, int goal, boolean diagonals) {
        return compute((StepRelation) region, goal, diagonals);
    }

    static float[] compute(StepRelation steps, int goal, boolean diagonals) {
        Nf2.requireOpen(steps, goal);
        int size = steps.size();
        int allowed = diagonals ? 0xFF : 0x0F;
        int[] offset = steps.frame().offsets();
        int[] waves = new int[size];
        int[] queue = new int[size];
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        Arrays.fill(waves, -1);
        waves[goal] = 0;
        queue[0] = goal;
        for (int head = 0, tail = 1; head < tail; head++) {
            int q = queue[head];
            int wave = waves[q] + 1;
            if (steps.plain(q)) {
                for (int bits = steps.moves(q) & allowed; bits != 0; bits &= bits - 1) {
                    int target = q + offset[Integer.numberOfTrailingZeros(bits)];
                    if (waves[target] < 0) {
                        waves[target] = wave;
                        queue[tail++] = target;
                    }
                }
                continue;
            }
            int count = steps.neighbours(q, targets, directions);
            for (int k = 0; k < count; k++) {
                if ((allowed >> directions[k] & 1) != 0 && waves[targets[k]] < 0) {
                    waves[targets[k]] = wave;
                    queue[tail++] = targets[k];
                }
            }
        }
        return metres(waves, steps.frame().cell());
    }

    private static float[] metres(int[] waves, double cell) {
        float[] metres = new float[waves.length];
        for (int q = 0; q < waves.length; q++) {
            metres[q] = waves[q] < 0 ? UNREACHABLE : (float) (waves[q] * cell);
        }
        return metres;
    }
}
