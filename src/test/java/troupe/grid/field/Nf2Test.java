package troupe.grid.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import troupe.scene.Journey.Spread;

/** Checks NF2 on small places worked out by hand. */
class Nf2Test {
    /** In a corridor of three cells the skeleton is the middle row, up to the ends, and nothing else. */
    @Test
    void skeletonOfACorridorIsItsMiddle() {
        MaskSteps steps = MaskSteps.of(
                "#############", //
                "#...........#",
                "#...........#",
                "#...........#",
                "#############");
        int goal = steps.frame().index(11, 2);
        Nf2 fields = new Nf2(steps).compute(goal, Spread.BREADTH);
        assertEquals(
                Arrays.asList(".............", ".............", "..oooooooooo.", ".............", "............."),
                rows(steps, fields));
        assertEquals(0, fields.potential(goal));
        assertEquals(9, fields.waves(steps.frame().index(2, 2)));
        assertEquals(10, fields.waves(steps.frame().index(1, 2)));
        assertEquals(10, fields.waves(steps.frame().index(2, 1)));
    }

    @Test
    void skeletonGoesRoundAHole() {
        MaskSteps steps = MaskSteps.of(
                "#########", //
                "#.......#",
                "#.......#",
                "#.......#",
                "#...#...#",
                "#.......#",
                "#.......#",
                "#.......#",
                "#########");
        Nf2 fields = new Nf2(steps).compute(steps.frame().index(1, 1), Spread.BREADTH);
        FieldsOracle oracle = new FieldsOracle(steps, "ring");
        oracle.checkLoops(fields);
        oracle.checkThinByRecount(fields);
        assertTrue(fields.skeleton(steps.frame().index(1, 1)), "the goal belongs to the skeleton");
    }

    @Test
    void otherPiecesHaveASkeletonButNoPotential() {
        MaskSteps steps = MaskSteps.of(
                "#########", //
                "#...#...#",
                "#...#...#",
                "#...#...#",
                "#########");
        Nf2 fields = new Nf2(steps).compute(steps.frame().index(1, 1), Spread.CLEARANCE);
        int beyond = steps.frame().index(6, 2);
        assertTrue(fields.skeleton(beyond));
        assertEquals(Nf2.UNREACHABLE, fields.potential(beyond));
        assertEquals(-1, fields.waves(beyond));
    }

    /**
     * Two ways round a block, a short narrow one and a long wide one: by breadth the short way counts, widest
     * place first goes round the long way before it squeezes through the narrow one.
     */
    @Test
    void clearanceOrderTakesTheWideWay() {
        String[] rows = new String[24];
        Arrays.fill(rows, 0, 24, "#" + ".".repeat(28) + "#");
        rows[0] = "#".repeat(30);
        rows[23] = rows[0];
        for (int row = 12; row < 22; row++) {
            rows[row] = "#.......############.........#";
        }
        MaskSteps steps = MaskSteps.of(rows);
        int goal = steps.frame().index(3, 5);
        int far = steps.frame().index(25, 5);
        Nf2 breadth = new Nf2(steps).compute(goal, Spread.BREADTH);
        Nf2 clearance = new Nf2(steps).compute(goal, Spread.CLEARANCE);
        assertTrue(breadth.potential(far) < clearance.potential(far));
        FieldsOracle oracle = new FieldsOracle(steps, "two ways");
        oracle.checkPotential(clearance);
        oracle.descend(clearance, far);
        oracle.descend(breadth, far);
    }

    @Test
    void distanceIsThatOfTheNearestClosedCell() {
        MaskSteps steps = MaskSteps.of("#####", "#...#", "#...#", "#...#", "#####");
        Nf2 fields = new Nf2(steps);
        assertEquals(2, fields.distance(steps.frame().index(2, 2)));
        assertEquals(1, fields.distance(steps.frame().index(1, 2)));
        assertEquals(0, fields.distance(0));
        assertFalse(fields.skeleton(0));
    }

    @Test
    void rejectsClosedGoals() {
        Nf2 fields = new Nf2(MaskSteps.of("#.#"));
        assertThrows(IllegalArgumentException.class, () -> fields.compute(0, Spread.BREADTH));
        assertThrows(IllegalArgumentException.class, () -> fields.compute(3, Spread.BREADTH));
    }

    private static java.util.List<String> rows(MaskSteps steps, Nf2 fields) {
        String[] rows = new String[steps.frame().rows()];
        for (int row = 0; row < rows.length; row++) {
            StringBuilder text = new StringBuilder();
            for (int col = 0; col < steps.frame().cols(); col++) {
                text.append(fields.skeleton(steps.frame().index(col, row)) ? 'o' : '.');
            }
            rows[rows.length - 1 - row] = text.toString();
        }
        return Arrays.asList(rows);
    }
}
