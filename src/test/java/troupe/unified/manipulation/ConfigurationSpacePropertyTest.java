package troupe.unified.manipulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.grid.GridFrame;
import troupe.scene.World;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;

/** Compares the stamped poses with each pose's own distances to the places of the path. */
class ConfigurationSpacePropertyTest {

    @Test
    void barsThePosesThatCollideWithAPlace() {
        Random random = new Random(12);
        int barred = 0;
        for (int trial = 0; trial < 40; trial++) {
            World world = new World(3 + random.nextDouble(), 3, 0.1 + 0.1 * random.nextDouble());
            GridFrame frame = GridFrame.of(world);
            ExpectedPath path = walk(random, frame);
            Polygon shape = Shapes.any(
                    random, 0.5 + 2 * random.nextDouble(), 0.5 + 2 * random.nextDouble(), 0.2 + random.nextDouble());
            Movable movable = new Movable(
                    0, Plans.solid(shape, random.nextDouble(), 0.7, true), world.cell(), 1 + random.nextInt(8));
            ConfigurationSpace space = new ConfigurationSpace(movable, path);
            barred += check(space, movable, path, frame, random.nextInt(movable.headings()));
        }
        assertTrue(barred > 3000, "only " + barred + " poses were barred");
    }

    private static int check(ConfigurationSpace space, Movable movable, ExpectedPath path, GridFrame frame, int k) {
        int homeCol = frame.colAt(movable.centroid().x());
        int homeRow = frame.rowAt(movable.centroid().y());
        IntStream.Builder cells = IntStream.builder();
        for (int j = -homeRow - 3; j < frame.rows() - homeRow + 3; j++) {
            for (int i = -homeCol - 3; i < frame.cols() - homeCol + 3; i++) {
                boolean collides = collides(movable, path, frame, i, j, k);
                String at = i + ", " + j + ", " + k;
                assertEquals(collides, space.contains(i, j, k), at);
                assertEquals(collides, path.collides(movable, new LatticePose(i, j, k)), at);
                int col = homeCol + i;
                int row = homeRow + j;
                if (collides && col >= 0 && row >= 0 && col < frame.cols() && row < frame.rows()) {
                    cells.add(frame.index(col, row));
                }
            }
        }
        int[] expected = cells.build().toArray();
        assertArrayEquals(expected, space.poses(k));
        return expected.length;
    }

    /** Measures the obstacle itself, moved by its pose. */
    private static boolean collides(Movable movable, ExpectedPath path, GridFrame frame, int i, int j, int k) {
        Pose pose = new Pose(
                movable.centroid().x() + i * frame.cell(),
                movable.centroid().y() + j * frame.cell(),
                k * 2 * Math.PI / movable.headings());
        Polygon outline = movable.obstacle().outline().at(pose);
        for (int n = 0; n < path.size(); n++) {
            double floor = path.floor(n);
            boolean meets = movable.obstacle().offset() < floor + Plans.BODY - 1e-9
                    && movable.obstacle().top() > floor + 1e-9;
            double x = frame.centreX(frame.col(path.cell(n)));
            double y = frame.centreY(frame.row(path.cell(n)));
            if (meets && outline.distance(x, y) < path.radius(n) - 1e-9) {
                return true;
            }
        }
        return false;
    }

    private static ExpectedPath walk(Random random, GridFrame frame) {
        int size = 1 + random.nextInt(25);
        int[] cells = new int[size];
        double[] floors = new double[size];
        double[] radii = new double[size];
        int col = random.nextInt(frame.cols());
        int row = random.nextInt(frame.rows());
        double floor = 0;
        for (int n = 0; n < size; n++) {
            cells[n] = frame.index(col, row);
            floors[n] = floor;
            radii[n] = random.nextBoolean() ? 0.25 : 0.15;
            int direction = random.nextInt(3) * 2 % 8;
            col = Math.max(0, Math.min(frame.cols() - 1, col + GridFrame.dx(direction)));
            row = Math.max(0, Math.min(frame.rows() - 1, row + GridFrame.dy(direction)));
            floor += random.nextInt(4) == 0 ? 0.2 : 0;
        }
        return new ExpectedPath(frame, Plans.BODY, cells, floors, radii);
    }
}
