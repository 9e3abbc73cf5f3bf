package troupe.grid.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.grid.region.RandomScenes;
import troupe.grid.region.Region;
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
    void layeredScenesWithCrossingsKeepTheirPiecesAndHaveNoLocalMinimum() {
        int ridge = 0;
        int medial = 0;
        for (long seed = SEED; seed < SEED + 40; seed++) {
            Region region = Region.of(RandomScenes.layered(seed, 7, 0.1), RandomScenes.actor(seed));
            Random random = new Random(seed);
            int goal = RandomMasks.place(random, region);
            if (goal < 0 || goal >= region.spanCount()) {
                continue;
            }
            Nf2 fields = new Nf2(region).compute(goal, Spread.values()[(int) (seed & 1)]);
            FieldsOracle oracle = new FieldsOracle(region, "seed " + seed);
            oracle.checkPotential(fields);
            oracle.checkPieces(fields);
            oracle.checkThin(fields);
            int[] counts = oracle.ridgeAndMedial(fields);
            ridge += counts[0];
            medial += counts[1];
        }
        assertTrue(medial >= 0.95 * ridge, "seed " + SEED + ": " + medial + " of " + ridge + " are medial");
    }

    @Test
    void potentialsOfAnEarlierGoalLeaveNoTrace() {
        Random random = new Random(SEED);
        for (int round = 0; round < 40; round++) {
            MaskSteps steps = RandomMasks.next(random, 30);
            int first = RandomMasks.place(random, steps);
            int second = RandomMasks.place(random, steps);
            if (first < 0) {
                continue;
            }
            Nf2 used = new Nf2(steps).compute(first, Spread.CLEARANCE).compute(second, Spread.BREADTH);
            Nf2 fresh = new Nf2(steps).compute(second, Spread.BREADTH);
            for (int q = 0; q < steps.size(); q++) {
                assertEquals(fresh.potential(q), used.potential(q), "seed " + SEED + ", round " + round);
                assertEquals(fresh.skeleton(q), used.skeleton(q), "seed " + SEED + ", round " + round);
            }
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
            oracle.checkMedial(fields);
        }
    }
}
