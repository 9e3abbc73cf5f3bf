package troupe.grid;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.scene.Journey.Spread;

/** Checks on many random flat masks what must hold of the skeleton and the potential. */
class Nf2PropertyTest {
    private static final long SEED = Long.getLong("troupe.seed", 20_253);

    @Test
    void smallMasksKeepTheirTopologyAndHaveNoLocalMinimum() {
        Random random = new Random(SEED);
        for (int round = 0; round < 400; round++) {
            MaskSteps steps = RandomMasks.next(random, 24);
            int goal = RandomMasks.place(random, steps);
            if (goal < 0) {
                continue;
            }
            Spread spread = Spread.values()[round % 2];
            Nf2 fields = new Nf2(steps).compute(goal, spread);
            FieldsOracle oracle = new FieldsOracle(steps, "seed " + SEED + ", round " + round);
            oracle.checkPotential(fields);
            oracle.checkPieces(fields);
            oracle.checkLoops(fields);
            oracle.checkThin(fields);
            oracle.checkThinByRecount(fields);
        }
    }

    @Test
    void largerMasksHaveMedialSkeletons() {
        Random random = new Random(SEED);
        for (int round = 0; round < 12; round++) {
            MaskSteps steps = RandomMasks.next(random, 90);
            int goal = RandomMasks.place(random, steps);
            if (goal < 0) {
                continue;
            }
            Nf2 fields = new Nf2(steps).compute(goal, Spread.BREADTH);
            FieldsOracle oracle = new FieldsOracle(steps, "seed " + SEED + ", round " + round);
            oracle.checkPotential(fields);
            oracle.checkPieces(fields);
            oracle.checkLoops(fields);
            oracle.checkThin(fields);
            double share = oracle.medialShare(fields, 2, true);
            assertTrue(share >= 0.9, "seed " + SEED + ", round " + round + ": " + share + " of the skeleton is medial");
        }
    }
}
