package troupe.unified.manipulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;

/** Makes small scenes, straight expected paths and questions for the tests of this package. */
public final class Plans {
    static final double BODY = 1.7;

    private Plans() {}

    public static Scene scene(double width, double depth, double cell, Obstacle... obstacles) {
        return new Scene("", new World(width, depth, cell), List.of(obstacles), List.of(), List.of(), List.of());
    }

    public static Scene scene(World world, List<Obstacle> obstacles, List<Ditch> ditches) {
        return new Scene("", world, obstacles, ditches, List.of(), List.of());
    }

    public static Obstacle wall(double minX, double minY, double maxX, double maxY) {
        return solid(Polygon.rectangle(minX, minY, maxX, maxY), 0, 2, false);
    }

    public static Obstacle crate(double minX, double minY, double maxX, double maxY) {
        return solid(Polygon.rectangle(minX, minY, maxX, maxY), 0, 1, true);
    }

    public static Obstacle solid(Polygon outline, double offset, double height, boolean movable) {
        return new Obstacle("o", "", outline, offset, height, movable, 20, "");
    }

    /** Returns the path on the ground through the cells of a row from one x to another, in metres. */
    public static ExpectedPath along(Scene scene, double y, double fromX, double toX, double radius) {
        GridFrame frame = GridFrame.of(scene.world());
        List<Integer> cells = new ArrayList<>();
        int step = fromX <= toX ? 1 : -1;
        for (int col = frame.colAt(fromX); col != frame.colAt(toX) + step; col += step) {
            cells.add(frame.index(col, frame.rowAt(y)));
        }
        return path(frame, cells, radius);
    }

    static ExpectedPath path(GridFrame frame, List<Integer> cells, double radius) {
        double[] radii = new double[cells.size()];
        java.util.Arrays.fill(radii, radius);
        return new ExpectedPath(
                frame, BODY, cells.stream().mapToInt(c -> c).toArray(), new double[cells.size()], radii);
    }

    public static Movable movable(Scene scene, int headings) {
        return Movable.of(scene, headings).get(0);
    }

    /** Asks for the first movable obstacle of a scene, without a grip. */
    static Question free(Scene scene, int headings, ExpectedPath path, Prices prices) {
        Movable movable = movable(scene, headings);
        return new Question(
                movable,
                new Surroundings(scene),
                new ConfigurationSpace(movable, path),
                prices,
                Optional.empty(),
                path.cell(0));
    }

    static Instance solved(Question question) {
        Instance instance = new Instance(question);
        instance.advance(Long.MAX_VALUE, Long.MAX_VALUE);
        return instance;
    }
}
