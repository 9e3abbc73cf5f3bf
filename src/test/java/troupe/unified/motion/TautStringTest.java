package troupe.unified.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Line;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.body.SweptBody;

class TautStringTest {
    private static SweptBody body(double radius, Polygon... walls) {
        List<Obstacle> obstacles = new ArrayList<>();
        for (Polygon wall : walls) {
            obstacles.add(new Obstacle("w" + obstacles.size(), "", wall, 0, 3, false, 20, ""));
        }
        Scene scene = new Scene("", World.of(10, 10), obstacles, List.of(), List.of(), List.of());
        return new SweptBody(scene, Actor.walker("a", radius, 0));
    }

    private static double length(List<Point> path) {
        double sum = 0;
        for (int i = 1; i < path.size(); i++) {
            sum += path.get(i - 1).distance(path.get(i));
        }
        return sum;
    }

    private static Line line(Point a, Point b) {
        return new Line(a.x(), a.y(), b.x(), b.y());
    }

    /** Walks right along y = 1, then up along x = 9. */
    private static List<Point> elbow() {
        List<Point> path = new ArrayList<>();
        for (int i = 10; i <= 90; i++) {
            path.add(new Point(i / 10.0, 1));
        }
        for (int i = 11; i <= 90; i++) {
            path.add(new Point(9, i / 10.0));
        }
        return path;
    }

    @Test
    void becomesStraightWhereNothingIsInTheWay() {
        SweptBody body = body(0.25);
        List<Point> taut = new TautString(l -> body.fits(l, 0, 0.25)).pull(elbow());
        assertEquals(List.of(new Point(1, 1), new Point(9, 9)), taut);
    }

    @Test
    void bendsRoundACornerHardlyLongerThanTheTightestWay() {
        SweptBody body = body(0.25, Polygon.rectangle(0, 3, 7, 10));
        List<Point> taut = new TautString(l -> body.fits(l, 0, 0.25)).pull(elbow());
        for (int i = 1; i < taut.size(); i++) {
            assertTrue(body.fits(line(taut.get(i - 1), taut.get(i)), 0, 0.25));
        }
        double past = Math.hypot(6, 2) + Math.hypot(2, 6);
        assertTrue(length(taut) >= past, "through the corner itself: " + past);
        assertTrue(length(taut) < 1.03 * past, length(taut) + " against " + past);
    }

    @Test
    void keepsAStepThatIsNotAllowedAndLeadsItRoundWhereItCan() {
        SweptBody body = body(0.25, Polygon.rectangle(4, 0, 4.05, 1));
        List<Point> grid = List.of(new Point(3.9, 1.2301), new Point(4.15, 1.2301));
        TautString string = new TautString(l -> body.fits(l, 0, 0.25));
        List<Point> taut = string.pull(grid);
        assertEquals(3, taut.size());
        assertTrue(body.fits(line(taut.get(0), taut.get(1)), 0, 0.25));
        assertTrue(body.fits(line(taut.get(1), taut.get(2)), 0, 0.25));
        assertEquals(grid, new TautString(l -> false).pull(grid));
    }

    @Test
    void randomPathsNeverGrowAndEndWhereTheyDid() {
        Random random = new Random(81);
        for (int trial = 0; trial < 200; trial++) {
            Polygon[] walls = new Polygon[6];
            for (int i = 0; i < walls.length; i++) {
                double x = random.nextDouble() * 9;
                double y = random.nextDouble() * 9;
                walls[i] = Polygon.rectangle(x, y, x + 0.2 + random.nextDouble(), y + 0.2 + random.nextDouble());
            }
            SweptBody body = body(0.2, walls);
            List<Point> path = wander(body, random);
            List<Point> taut = new TautString(l -> body.fits(l, 0, 0.2)).pull(path);
            assertTrue(length(taut) <= length(path) + 1e-9, "seed 81, trial " + trial);
            assertEquals(path.get(0), taut.get(0));
            assertEquals(path.get(path.size() - 1), taut.get(taut.size() - 1));
            for (int i = 1; i < taut.size(); i++) {
                assertTrue(body.fits(line(taut.get(i - 1), taut.get(i)), 0, 0.2), "seed 81, trial " + trial);
            }
        }
    }

    private static List<Point> wander(SweptBody body, Random random) {
        List<Point> path = new ArrayList<>();
        Point at = new Point(5, 5);
        for (int tries = 0; tries < 100 && path.size() < 60; tries++) {
            Point next = new Point(
                    path.isEmpty() ? random.nextDouble() * 10 : at.x() + random.nextDouble() - 0.5,
                    path.isEmpty() ? random.nextDouble() * 10 : at.y() + random.nextDouble() - 0.5);
            if (body.fits(path.isEmpty() ? line(next, next) : line(at, next), 0, 0.2)) {
                path.add(next);
                at = next;
            }
        }
        return path.isEmpty() ? List.of(at) : path;
    }
}
