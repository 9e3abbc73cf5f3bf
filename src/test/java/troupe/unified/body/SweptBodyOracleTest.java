package troupe.unified.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Line;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;

/** Compares the exact answers with ones from points laid densely along the line and over the disc. */
class SweptBodyOracleTest {
    private static final double UNSURE = 0.012;

    private final Actor actor = Actor.standard("a");

    private static Scene scene(List<Obstacle> obstacles, List<Ditch> ditches) {
        return new Scene("", World.of(4, 4), obstacles, ditches, List.of(), List.of());
    }

    private static Obstacle block(Polygon outline, double offset, double height) {
        return new Obstacle("o", "", outline, offset, height, false, 20, "");
    }

    private static Polygon triangle(Random random) {
        double x = random.nextDouble() * 4;
        double y = random.nextDouble() * 4;
        return Polygon.of(
                x,
                y,
                x + 0.3 + random.nextDouble() * 1.5,
                y + random.nextDouble() * 0.2,
                x + random.nextDouble() * 0.2,
                y + 0.3 + random.nextDouble());
    }

    private static Line line(Random random) {
        double x = 0.5 + random.nextDouble() * 3;
        double y = 0.5 + random.nextDouble() * 3;
        return new Line(x, y, x + random.nextDouble() - 0.5, y + random.nextDouble() - 0.5);
    }

    @Test
    void bodyFitsWhereEveryPointOfTheLineIsFarEnough() {
        Random random = new Random(82);
        int fitted = 0;
        for (int trial = 0; trial < 3000; trial++) {
            List<Obstacle> obstacles = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                obstacles.add(block(triangle(random), random.nextInt(3), 0.1 + random.nextDouble()));
            }
            Line line = line(random);
            double nearest = nearest(obstacles, line);
            boolean fits = new SweptBody(scene(obstacles, List.of()), actor).fits(line, 0, 0.25);
            fitted += fits ? 1 : 0;
            if (Math.abs(nearest - 0.25) > UNSURE) {
                assertEquals(nearest > 0.25, fits, "seed 82, trial " + trial);
            }
        }
        assertTrue(fitted > 300 && fitted < 2700, fitted + " of 3000");
    }

    private double nearest(List<Obstacle> obstacles, Line line) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i <= 100; i++) {
            double x = line.ax() + i / 100.0 * (line.bx() - line.ax());
            double y = line.ay() + i / 100.0 * (line.by() - line.ay());
            nearest = Math.min(nearest, Math.min(Math.min(x, y), Math.min(4 - x, 4 - y)));
            for (Obstacle o : obstacles) {
                if (o.top() > actor.stepHeight() && o.offset() < actor.bodyHeight()) {
                    nearest = Math.min(nearest, o.outline().distance(x, y));
                }
            }
        }
        return nearest;
    }

    @Test
    void feetRestWhereEveryPointOfTheDiscHasTheSameFloor() {
        Random random = new Random(83);
        int rested = 0;
        for (int trial = 0; trial < 2000; trial++) {
            List<Obstacle> plates = new ArrayList<>();
            List<Ditch> ditches = List.of(new Ditch("d", "", triangle(random), 0.1));
            for (int i = 0; i < 3; i++) {
                plates.add(block(triangle(random), 0, random.nextBoolean() ? 0.1 : 0.2));
            }
            SweptBody body = new SweptBody(scene(plates, ditches), actor);
            Line line = line(random);
            double floor = body.floorAt(line.ax(), line.ay(), 0);
            boolean rests = body.rests(line, floor);
            rested += rests ? 1 : 0;
            if (rests) {
                assertEquals(0, others(body, line, floor, 0.0999, 9), "seed 83, trial " + trial);
            } else {
                assertTrue(
                        others(body, line, floor, 0.1 + UNSURE, 9) > 0
                                || others(body, line, floor, 0.1 + UNSURE, 100) > 0,
                        "seed 83, trial " + trial);
            }
        }
        assertTrue(rested > 200 && rested < 1800, rested + " of 2000");
    }

    /** Counts points of the swept disc whose floor is another. */
    private static int others(SweptBody body, Line line, double floor, double radius, int rings) {
        int others = 0;
        for (int i = 0; i <= 40; i++) {
            double x = line.ax() + i / 40.0 * (line.bx() - line.ax());
            double y = line.ay() + i / 40.0 * (line.by() - line.ay());
            for (int k = -rings; k <= rings; k++) {
                for (int m = -rings; m <= rings; m++) {
                    if (k * k + m * m <= rings * rings
                            && body.floorAt(x + k * radius / rings, y + m * radius / rings, floor) != floor) {
                        others++;
                    }
                }
            }
        }
        return others;
    }

    @Test
    void seamBetweenPlatesOfOneHeightIsNoEdge() {
        List<Obstacle> plates =
                List.of(block(Polygon.rectangle(0, 0, 2, 4), 0, 0.2), block(Polygon.rectangle(2, 0, 4, 4), 0, 0.2));
        SweptBody body = new SweptBody(scene(plates, List.of()), actor);
        assertTrue(body.rests(new Line(1, 1, 3, 2), 0.2));
    }

    @Test
    void groundIsAWallForOneDownInADitch() {
        List<Ditch> ditches = List.of(new Ditch("d", "", Polygon.rectangle(1, 1, 3, 3), 1));
        SweptBody body = new SweptBody(scene(List.of(), ditches), actor);
        assertTrue(body.fits(new Line(1.3, 1.3, 2.7, 2.7), -1, 0.25));
        assertFalse(body.fits(new Line(1.2, 1.3, 2.7, 2.7), -1, 0.25));
        assertTrue(body.fits(new Line(0.5, 0.5, 3.5, 0.5), 0, 0.25), "the ditch is no wall for one above");
        assertFalse(body.isSupported(new Line(0.5, 0.95, 3.5, 0.95), 0));
        assertTrue(body.isSupported(new Line(0.5, 0.85, 3.5, 0.85), 0));
    }
}
