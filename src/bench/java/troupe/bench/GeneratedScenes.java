package troupe.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import troupe.geometry.Polygon;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;

/** Makes the scenes of the grid benchmarks: sixty turned boxes and low walls in a hall of 25.6 m. */
final class GeneratedScenes {
    static final double SIDE = 25.6;
    private static final int OBSTACLES = 60;
    private static final long SEED = 60;

    private GeneratedScenes() {}

    /** Makes the scene with {@code size x size} cells; obstacles of 0.5 to 3 m, a third low enough to vault. */
    static Scene hall(int size) {
        Random random = new Random(SEED);
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 0; i < OBSTACLES; i++) {
            double height = i % 3 == 0 ? 0.5 + 0.5 * random.nextDouble() : 2.5;
            Polygon outline = box(random, 0.5 + 2.5 * random.nextDouble(), 0.3 + random.nextDouble());
            obstacles.add(new Obstacle("o" + i, "", outline, 0, height, false, Obstacle.DEFAULT_MASS, ""));
        }
        World world = new World(SIDE, SIDE, SIDE / size);
        return new Scene("", world, obstacles, List.of(), List.of(), List.of());
    }

    private static Polygon box(Random random, double length, double breadth) {
        double x = 1.5 + (SIDE - 3) * random.nextDouble();
        double y = 1.5 + (SIDE - 3) * random.nextDouble();
        double turn = Math.PI * random.nextDouble();
        double ux = StrictMath.cos(turn) * length / 2;
        double uy = StrictMath.sin(turn) * length / 2;
        double vx = -StrictMath.sin(turn) * breadth / 2;
        double vy = StrictMath.cos(turn) * breadth / 2;
        return Polygon.of(
                x - ux - vx, y - uy - vy, x + ux - vx, y + uy - vy, x + ux + vx, y + uy + vy, x - ux + vx, y - uy + vy);
    }
}
