package troupe.unified.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.manipulation.Plans;
import troupe.unified.manipulation.Shapes;

/** Checks holds, outlines and stamps of movable obstacles. */
class MovableTest {
    @Test
    void findsTheMovableObstaclesWithTheirNumbers() {
        Scene scene = Plans.scene(4, 4, 0.1, Plans.wall(0, 0, 1, 1), Plans.crate(2, 2, 3, 3), Plans.crate(1, 1, 2, 2));
        assertEquals(
                List.of(1, 2),
                Movable.of(scene, 8).stream().map(Movable::number).toList());
    }

    @Test
    void putsAHoldEveryThirtyCentimetresFromTheFirstCorner() {
        Movable crate = new Movable(0, Plans.crate(1, 1, 1.5, 1.4), 0.1, 24);
        List<Point> holds = crate.holds();
        // a perimeter of 1.8 m: 0, 0.3, 0.6, 0.9, 1.2, 1.5; the one at 1.8 would be the first again
        assertEquals(6, holds.size());
        double[][] expected = {{1, 1}, {1.3, 1}, {1.5, 1.1}, {1.5, 1.4}, {1.2, 1.4}, {1, 1.3}};
        for (int n = 0; n < expected.length; n++) {
            assertEquals(expected[n][0], holds.get(n).x(), 1e-9, "hold " + n);
            assertEquals(expected[n][1], holds.get(n).y(), 1e-9, "hold " + n);
        }
    }

    @Test
    void turnsAboutTheCentroidAndShiftsByCells() {
        Movable crate = new Movable(0, Plans.crate(1, 1, 3, 2), 0.5, 4);
        assertEquals(crate.obstacle().outline(), crate.outline(LatticePose.HOME));
        Polygon turned = crate.outline(new LatticePose(2, -1, 1));
        double[][] expected = {{3.5, 0}, {3.5, 2}, {2.5, 2}, {2.5, 0}};
        for (int n = 0; n < expected.length; n++) {
            assertEquals(expected[n][0], turned.x(n), 1e-12);
            assertEquals(expected[n][1], turned.y(n), 1e-12);
        }
        assertEquals(Math.sqrt(1.25), crate.farthest(), 1e-12);
    }

    @Test
    void meetsABodyFromTheFloorItself() {
        Movable plank = new Movable(0, Plans.solid(Polygon.rectangle(0, 0, 1, 1), 0, 0.1, true), 0.1, 1);
        assertTrue(plank.meets(0, 1.7));
        assertFalse(plank.meets(0.1, 1.7));
        Movable lamp = new Movable(0, Plans.solid(Polygon.rectangle(0, 0, 1, 1), 1.7, 0.1, true), 0.1, 1);
        assertFalse(lamp.meets(0, 1.7));
        assertTrue(lamp.meets(0.2, 1.7));
    }

    @Test
    void stampHoldsTheCellsThatAreNear() {
        Random random = new Random(5);
        for (int trial = 0; trial < 60; trial++) {
            World world = new World(6, 5, 0.05 + 0.2 * random.nextDouble());
            GridFrame frame = GridFrame.of(world);
            double size = 0.3 + random.nextDouble();
            Polygon shape = Shapes.any(random, 6 * random.nextDouble(), 5 * random.nextDouble(), size);
            Movable movable = new Movable(0, Plans.solid(shape, 0, 1, true), world.cell(), 1 + random.nextInt(12));
            int k = random.nextInt(movable.headings());
            double radius = random.nextInt(5) == 0 ? 0 : 0.4 * random.nextDouble();
            Polygon outline = movable.outline(new LatticePose(0, 0, k));
            for (int row = -20; row < frame.rows() + 20; row++) {
                for (int col = -20; col < frame.cols() + 20; col++) {
                    boolean near = outline.distance(frame.centreX(col), frame.centreY(row)) < radius - 1e-9;
                    assertEquals(near, movable.isNear(0, 0, k, col, row, radius), trial + ": " + col + ", " + row);
                }
            }
        }
    }
}
