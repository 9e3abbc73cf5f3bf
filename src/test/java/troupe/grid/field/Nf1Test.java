package troupe.grid.field;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.grid.region.RandomScenes;
import troupe.grid.region.Region;

/** Checks the NF1 potential by hand and against a slow search. */
class Nf1Test {
    private static final long SEED = Long.getLong("troupe.seed", 20_254);
    private static final float FAR = Nf1.UNREACHABLE;

    /** A wall of two cells; the step round its end has no diagonal, because that would cut the corner. */
    @Test
    void countsWavesRoundAWall() {
        MaskSteps steps = MaskSteps.of(
                "....", //
                ".##.", "....");
        assertArrayEquals(new float[] {0, 1, 2, 3, 1, FAR, FAR, 4, 2, 3, 4, 5}, Nf1.compute(steps, 0, true));
    }

    @Test
    void diagonalsCountOneWaveAndMayBeLeftOut() {
        MaskSteps steps = MaskSteps.of("...", "...", "...");
        assertArrayEquals(new float[] {0, 1, 2, 1, 1, 2, 2, 2, 2}, Nf1.compute(steps, 0, true));
        assertArrayEquals(new float[] {0, 1, 2, 1, 2, 3, 2, 3, 4}, Nf1.compute(steps, 0, false));
    }

    @Test
    void equalsASlowSearchOverLinksAndCrossings() {
        for (long seed = SEED; seed < SEED + 30; seed++) {
            Region region = Region.of(RandomScenes.layered(seed, 6, 0.1), RandomScenes.actor(seed));
            int goal = RandomMasks.place(new Random(seed), region);
            if (goal < 0) {
                continue;
            }
            float[] metres = Nf1.compute(region, goal);
            int[] steps = new FieldsOracle(region, "").breadthFirst(goal, null);
            for (int q = 0; q < metres.length; q++) {
                float expected =
                        steps[q] < 0 ? FAR : (float) (steps[q] * region.frame().cell());
                assertEquals(expected, metres[q], "seed " + seed);
            }
        }
    }

    @Test
    void rejectsClosedGoals() {
        MaskSteps steps = MaskSteps.of(".#");
        assertThrows(IllegalArgumentException.class, () -> Nf1.compute(steps, 1, true));
        assertThrows(IllegalArgumentException.class, () -> Nf1.compute(steps, -1, true));
    }
}
