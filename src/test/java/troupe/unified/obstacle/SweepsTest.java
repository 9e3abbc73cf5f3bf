package troupe.unified.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.manipulation.Plans;
import troupe.unified.manipulation.Shapes;

/** Checks which moves have room: worked out by hand, and by looking at many moments of each move. */
class SweepsTest {
    private static final int EAST = 0;
    private static final int NORTH = 1;
    private static final int WEST = 2;
    private static final int SOUTH = 3;

    private static Sweeps sweeps(Scene scene, int headings) {
        Sweeps sweeps = new Surroundings(scene).sweeps(Plans.movable(scene, headings));
        sweeps.choose(0, 0, 0);
        return sweeps;
    }

    @Test
    void crateFlushInItsDoorwaySlidesButDoesNotTurn() {
        // coordinates that no double holds exactly
        Scene scene = Plans.scene(
                4,
                4,
                0.1,
                Plans.crate(1.3, 1.1, 2.3, 1.7),
                Plans.wall(0.1, 0.1, 3.9, 1.1),
                Plans.wall(0.1, 1.7, 3.9, 3.3));
        Sweeps sweeps = sweeps(scene, 24);
        assertTrue(sweeps.isFree());
        assertTrue(sweeps.canShift(EAST));
        assertTrue(sweeps.canShift(WEST));
        assertFalse(sweeps.canShift(NORTH));
        assertFalse(sweeps.canShift(SOUTH));
        for (int diagonal = 4; diagonal < 8; diagonal++) {
            assertFalse(sweeps.canShift(diagonal));
        }
        assertFalse(sweeps.canTurn(true));
        assertFalse(sweeps.canTurn(false));
        for (int i = -9; i <= 9; i++) {
            sweeps.choose(i, 0, 0);
            assertTrue(sweeps.canShift(EAST) && sweeps.canShift(WEST), "at " + i);
        }
    }

    @Test
    void equalBoxesSideBySideDoNotPassThroughEachOther() {
        Scene scene = Plans.scene(4, 4, 0.1, Plans.crate(1, 1, 2, 2), Plans.wall(2, 1, 3, 2));
        Sweeps sweeps = sweeps(scene, 24);
        assertFalse(sweeps.canShift(EAST));
        assertTrue(sweeps.canShift(NORTH));
        assertTrue(sweeps.canShift(WEST));
        assertFalse(sweeps.canShift(4));
        assertTrue(sweeps.canShift(5));
    }

    @Test
    void cornerToCornerIsNoContactUntilTheyMeetHeadOn() {
        Scene scene = Plans.scene(4, 4, 0.1, Plans.crate(1, 1, 2, 2), Plans.wall(2, 2, 3, 3));
        Sweeps sweeps = sweeps(scene, 24);
        assertTrue(sweeps.canShift(EAST), "slides along below it");
        assertTrue(sweeps.canShift(NORTH));
        assertFalse(sweeps.canShift(4), "north-east leads into it");
    }

    @Test
    void staysInTheWorld() {
        Scene scene = Plans.scene(4, 4, 0.1, Plans.crate(0, 1, 1, 2));
        Sweeps sweeps = sweeps(scene, 24);
        assertTrue(sweeps.isFree());
        assertFalse(sweeps.canShift(WEST));
        assertTrue(sweeps.canShift(EAST));
        assertTrue(sweeps.canShift(NORTH));
        assertFalse(sweeps.canTurn(true), "the corners of a square move outwards first");
        sweeps.choose(3, 0, 0);
        assertTrue(sweeps.canTurn(true), "0.3 m are more than the 0.21 m by which a corner leaves the square");
    }

    @Test
    void overlappingObstaclesDoNotMove() {
        Scene scene = Plans.scene(4, 4, 0.1, Plans.crate(1, 1, 2, 2), Plans.wall(1.9, 1, 3, 2));
        assertFalse(sweeps(scene, 4).isFree());
        assertFalse(sweeps(Plans.scene(4, 4, 0.1, Plans.crate(1, 1, 2, 2), Plans.wall(0.5, 0.5, 3, 3)), 4)
                .isFree());
        assertFalse(sweeps(Plans.scene(4, 4, 0.1, Plans.crate(1, 1, 2, 2), Plans.wall(1, 1, 2, 2)), 4)
                .isFree());
    }

    @Test
    void passesUnderAndOverWhatIsNotAsHigh() {
        Obstacle bridge = Plans.solid(Polygon.rectangle(2, 0, 3, 4), 1, 0.5, false);
        Scene scene = Plans.scene(4, 4, 0.1, Plans.crate(1, 1, 2, 2), bridge);
        assertTrue(sweeps(scene, 4).canShift(EAST));
        Obstacle low = Plans.solid(Polygon.rectangle(2, 0, 3, 4), 0.999, 0.5, false);
        assertFalse(
                sweeps(Plans.scene(4, 4, 0.1, Plans.crate(1, 1, 2, 2), low), 4).canShift(EAST));
    }

    @Test
    void turnIsStoppedByAPostBetweenTwoHeadingsThatAreFree() {
        // a long bar; a thin post stands in the middle of the sector between heading 0 and heading 1 of 4
        Scene scene = Plans.scene(
                6,
                6,
                0.1,
                Plans.solid(Polygon.rectangle(1, 2.9, 5, 3.1), 0, 1, true),
                Plans.wall(4.2, 4.2, 4.21, 4.21));
        Sweeps sweeps = sweeps(scene, 4);
        assertFalse(sweeps.canTurn(true));
        assertTrue(sweeps.canTurn(false));
    }

    @Test
    void hookCannotLeaveThePostItHoldsButAlongItsOpening() {
        Polygon hook = Polygon.of(1, 1, 2, 1, 2, 2, 1, 2, 1, 1.9, 1.9, 1.9, 1.9, 1.1, 1, 1.1);
        Scene scene = Plans.scene(4, 4, 0.5, Plans.solid(hook, 0, 1, true), Plans.wall(1.2, 1.45, 1.3, 1.55));
        Sweeps sweeps = sweeps(scene, 4);
        assertTrue(sweeps.isFree());
        assertFalse(sweeps.canShift(NORTH));
        assertFalse(sweeps.canShift(SOUTH));
        assertTrue(sweeps.canShift(WEST), "the post passes to the back of the opening");
        assertTrue(sweeps.canShift(EAST));
    }

    @Test
    void agreesWithManyMomentsOfEachMove() {
        Random random = new Random(77);
        int allowed = 0;
        int forbidden = 0;
        for (int trial = 0; trial < 500; trial++) {
            List<Obstacle> obstacles = new ArrayList<>();
            obstacles.add(Plans.solid(Shapes.any(random, 2, 2, 0.5), 0, 1, true));
            for (int n = 0; n < 3; n++) {
                double x = 1 + 2 * random.nextDouble();
                double y = 1 + 2 * random.nextDouble();
                obstacles.add(Plans.solid(Shapes.any(random, x, y, 0.6), 0, 1, false));
            }
            Scene scene = Plans.scene(new World(4, 4, 0.05 + 0.2 * random.nextDouble()), obstacles, List.of());
            Movable movable = Plans.movable(scene, 2 + random.nextInt(20));
            SlowSweep moments = new SlowSweep(scene, movable);
            Sweeps sweeps = new Surroundings(scene).sweeps(movable);
            assertEquals(moments.overlaps(movable.obstacle().outline()), !sweeps.isFree(), "trial " + trial);
            LatticePose from =
                    new LatticePose(random.nextInt(15) - 7, random.nextInt(15) - 7, random.nextInt(movable.headings()));
            if (moments.overlaps(movable.outline(from))) {
                continue;
            }
            sweeps.choose(from.i(), from.j(), from.k());
            for (int move = 0; move < 10; move++) {
                int sure = moments.judge(from, move);
                boolean can = move < 8 ? sweeps.canShift(move) : sweeps.canTurn(move == 8);
                if (sure != 0) {
                    assertEquals(sure > 0, can, "trial " + trial + ", move " + move);
                }
                allowed += sure > 0 ? 1 : 0;
                forbidden += sure < 0 ? 1 : 0;
            }
        }
        assertTrue(allowed > 700 && forbidden > 300, allowed + " allowed, " + forbidden + " forbidden");
    }
}
