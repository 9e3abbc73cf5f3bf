package troupe.unified.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.manipulation.Plans;

/** Checks support and what can be moved at all, worked out by hand. */
class SurroundingsTest {
    private static final World WORLD = new World(4, 4, 0.1);

    private static Obstacle table(boolean movable) {
        return Plans.solid(Polygon.rectangle(1, 1, 3, 2), 0.7, 0.05, movable);
    }

    private static Obstacle book(double minX, double minY) {
        return Plans.solid(Polygon.rectangle(minX, minY, minX + 0.4, minY + 0.4), 0.75, 0.1, true);
    }

    @Test
    void bookMayHangOverTheTableByTwoFifths() {
        Scene scene = Plans.scene(WORLD, List.of(book(2.0, 1.3), table(false)), List.of());
        Movable movable = Plans.movable(scene, 24);
        Support support = new Support(scene, movable);
        assertTrue(support.rests(0, 0, 0));
        assertTrue(support.rests(6, 0, 0), "flush with the end of the table");
        // one cell over the end: 3/4 of the columns of the sample, 0.4 m wide, stay on it
        assertTrue(support.rests(7, 0, 0));
        // two cells: half of the book
        assertFalse(support.rests(8, 0, 0));
        assertFalse(support.rests(9, 0, 0));
        assertTrue(support.rests(0, -4, 0), "three quarters of the rows");
        assertFalse(support.rests(0, -5, 0));
    }

    @Test
    void threeFifthsOfTheSampleCountNotTheCentroidAlone() {
        // 0.8 m deep over a table 0.5 m deep: the centroid is on it, five eighths of the sample at most
        Obstacle board = Plans.solid(Polygon.rectangle(1.2, 1.0, 1.6, 1.8), 0.75, 0.1, true);
        Obstacle shelf = Plans.solid(Polygon.rectangle(1, 1.2, 3, 1.7), 0.7, 0.05, false);
        Scene scene = Plans.scene(WORLD, List.of(board, shelf), List.of());
        Support support = new Support(scene, Plans.movable(scene, 24));
        assertTrue(support.rests(0, 0, 0), "rows 1.225 to 1.675: ten of sixteen, 62.5 percent");
        assertTrue(support.rests(0, 1, 0), "still all of the shelf");
        assertFalse(support.rests(0, 3, 0), "the centroid at 1.7 is on its edge");
        // turned by a quarter it lies along the shelf, 0.4 m deep
        assertTrue(support.rests(0, 1, 6));
    }

    @Test
    void groundEndsAtADitch() {
        Ditch ditch = new Ditch("d", "", Polygon.rectangle(2, 0, 3, 4), 1);
        World fine = new World(4, 4, 0.05);
        Scene scene = Plans.scene(fine, List.of(Plans.crate(1, 1, 2, 2)), List.of(ditch));
        Support support = new Support(scene, Plans.movable(scene, 24));
        assertTrue(support.rests(0, 0, 0));
        assertTrue(support.rests(8, 0, 0), "0.4 m over the edge: ten of sixteen columns of the sample");
        assertFalse(support.rests(9, 0, 0), "0.45 m: nine, 56 percent, though the centroid is on the ground");
        assertFalse(support.rests(10, 0, 0));
    }

    @Test
    void nothingRestsInADitchUnlessItStandsOnItsBottom() {
        Ditch ditch = new Ditch("d", "", Polygon.rectangle(0, 0, 4, 4), 1);
        Scene scene = Plans.scene(
                WORLD,
                List.of(Plans.crate(1, 1, 2, 2), Plans.solid(Polygon.rectangle(2, 2, 3, 3), -1, 0.5, true)),
                List.of(ditch));
        List<Movable> movables = Movable.of(scene, 24);
        assertFalse(new Support(scene, movables.get(0)).rests(0, 0, 0));
        assertTrue(new Support(scene, movables.get(1)).rests(0, 0, 0));
    }

    @Test
    void onlyTheTopsOfImmovableObstaclesCarry() {
        Scene scene = Plans.scene(WORLD, List.of(book(2.0, 1.3), table(true)), List.of());
        Surroundings surroundings = new Surroundings(scene);
        List<Movable> movables = Movable.of(scene, 24);
        assertFalse(surroundings.canMove(movables.get(0)));
    }

    @Test
    void whatCarriesAnotherCanBeMovedOnceThatIsGone() {
        Obstacle above = Plans.solid(Polygon.rectangle(1.2, 1.2, 1.8, 1.8), 1, 0.5, true);
        Scene scene = Plans.scene(WORLD, List.of(Plans.crate(1, 1, 2, 2), above), List.of());
        Surroundings surroundings = new Surroundings(scene);
        List<Movable> movables = Movable.of(scene, 24);
        assertFalse(surroundings.canMove(movables.get(0)));
        Surroundings after = surroundings.with(1, above.outline().shifted(0.8, 0));
        assertTrue(after.canMove(movables.get(0)), "they only touch");
        assertFalse(after.canMove(movables.get(1)), "moved for good");
        assertEquals(above.outline(), surroundings.outline(1));
    }

    @Test
    void movedObstaclesStandInTheWayWhereTheyAreNow() {
        Scene scene = Plans.scene(WORLD, List.of(Plans.crate(1, 1, 2, 2), Plans.crate(2.5, 3, 3.5, 4)), List.of());
        Movable first = Movable.of(scene, 24).get(0);
        Surroundings before = new Surroundings(scene);
        Surroundings after = before.with(1, Polygon.rectangle(2, 1, 3, 2));
        before.sweeps(first).choose(0, 0, 0);
        assertTrue(before.sweeps(first).canShift(0));
        after.sweeps(first).choose(0, 0, 0);
        assertFalse(after.sweeps(first).canShift(0));
    }
}
