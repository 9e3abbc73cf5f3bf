package troupe.unified.manipulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;

/** Compares instances in random small scenes with a slow search that shares no code but the definitions. */
class InstanceOracleTest {
    private static final Actor BROAD = Actor.standard("a");

    /** So thin that it can stand on either side of a corner without having room to pass it. */
    private static final Actor THIN = Actor.walker("b", 0.04, 0);

    private final Random random = new Random(2024);
    private final Random slices = new Random(7);
    private int found;
    private int failed;
    private int hard;

    private Scene scene(boolean withActor) {
        List<Obstacle> obstacles = new ArrayList<>();
        List<Ditch> ditches = new ArrayList<>();
        double x = 1 + random.nextDouble();
        double y = 1 + random.nextDouble();
        obstacles.add(Plans.solid(Shapes.any(random, x, y, 0.25 + 0.4 * random.nextDouble()), 0, 1, true));
        int count = 1 + random.nextInt(6);
        for (int n = 0; n < count; n++) {
            double height = random.nextInt(4) == 0 && withActor ? 0.2 : 1.5;
            obstacles.add(Plans.solid(
                    Shapes.any(
                            random, 3 * random.nextDouble(), 3 * random.nextDouble(), 0.15 + 0.4 * random.nextDouble()),
                    0,
                    height,
                    random.nextInt(4) == 0));
        }
        if (random.nextInt(3) == 0) {
            Polygon pit = Shapes.any(random, 3 * random.nextDouble(), 3 * random.nextDouble(), 0.5);
            ditches.add(new Ditch("d", "", pit, 1));
        }
        return Plans.scene(new World(3, 3, 0.15 + 0.1 * random.nextDouble()), obstacles, ditches);
    }

    private Prices prices() {
        return random.nextBoolean()
                ? new Prices(2, 3, random.nextInt(3), 1, 1)
                : new Prices(
                        1 + random.nextInt(100000),
                        1 + random.nextInt(100000),
                        1 + random.nextInt(50000),
                        random.nextInt(50000),
                        random.nextInt(50000));
    }

    /** Wanders about from the obstacle, so that most places nearby are barred. */
    private ExpectedPath path(Scene scene, Movable movable) {
        GridFrame frame = GridFrame.of(scene.world());
        int col = frame.colAt(movable.centroid().x());
        int row = frame.rowAt(movable.centroid().y());
        List<Integer> cells = new ArrayList<>();
        boolean whole = movable.headings() < 6 && random.nextInt(8) == 0;
        int size = whole ? 4000 : 1 + random.nextInt(120);
        int direction = 0;
        while (cells.size() < size) {
            cells.add(frame.index(col, row));
            direction = random.nextInt(3) == 0 ? random.nextInt(8) : direction;
            col = Math.max(1, Math.min(frame.cols() - 2, col + GridFrame.dx(direction)));
            row = Math.max(1, Math.min(frame.rows() - 2, row + GridFrame.dy(direction)));
        }
        return Plans.path(frame, cells, 0.1 + 0.15 * random.nextDouble());
    }

    /** Returns scenes in which the obstacle overlaps nothing, but for one in ten. */
    private Scene movableScene(boolean withActor) {
        while (true) {
            Scene scene = scene(withActor);
            if (new Surroundings(scene).sweeps(Plans.movable(scene, 4)).isFree() || random.nextInt(10) == 0) {
                return scene;
            }
        }
    }

    @Test
    void findsWhatTheSlowSearchFinds() {
        for (int trial = 0; trial < 45; trial++) {
            Scene scene = movableScene(false);
            Movable movable = Plans.movable(scene, 1 + (trial % 3 == 0 ? 2 : 2 + random.nextInt(9)));
            Question question = new Question(
                    movable,
                    new Surroundings(scene),
                    new ConfigurationSpace(movable, path(scene, movable)),
                    prices(),
                    Optional.empty(),
                    0);
            compare("trial " + trial, scene, question, Optional.empty());
        }
        assertTrue(found > 20 && failed > 2 && hard > 5, found + " found, " + failed + " failed, " + hard + " hard");
    }

    @Test
    void findsWhatTheSlowSearchFindsWithAGrip() {
        for (int trial = 0; trial < 60; trial++) {
            Scene scene = movableScene(true);
            Movable movable = Plans.movable(scene, 3 + random.nextInt(10));
            Region base = new RegionBuilder(scene, trial % 3 == 0 ? THIN : BROAD).region();
            int trigger = stand(base, movable);
            if (trigger < 0) {
                continue;
            }
            Question question = new Question(
                    movable,
                    new Surroundings(scene),
                    new ConfigurationSpace(movable, path(scene, movable)),
                    prices(),
                    Optional.of(SlowGrip.grip(scene, movable, base, trigger)),
                    trigger);
            compare("trial " + trial, scene, question, Optional.of(new SlowGrip(scene, movable, base, trigger)));
        }
        assertTrue(found > 20 && failed > 2 && hard > 5, found + " found, " + failed + " failed, " + hard + " hard");
    }

    /** Returns the open stable span that is nearest to the obstacle, -1 if there is none. */
    private static int stand(Region region, Movable movable) {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int q = 0; q < region.spanCount(); q++) {
            if (region.kind(q) == Kind.STABLE && (region.abilities(q) & Ability.WALK.bit()) != 0) {
                double distance = movable.obstacle().outline().distance(region.x(q), region.y(q));
                if (distance < least) {
                    least = distance;
                    best = q;
                }
            }
        }
        return best;
    }

    private void compare(String trial, Scene scene, Question question, Optional<SlowGrip> grip) {
        SlowInstance slow = new SlowInstance(scene, question, grip);
        slow.solve();
        Instance whole = Plans.solved(question);
        assertEquals(slow.found != null, whole.outcome().isFound(), trial);
        assertTrue(whole.expanded() <= slow.expanded, trial);
        Instance sliced = new Instance(question);
        Instance other = new Instance(question);
        while (sliced.outcome().isRunning()) {
            sliced.advance(1 + slices.nextInt(20), slices.nextInt(3) == 0 ? sliced.least() : Long.MAX_VALUE);
            other.advance(7, Long.MAX_VALUE);
        }
        assertEquals(whole.outcome(), sliced.outcome(), trial);
        assertEquals(whole.expanded(), sliced.expanded(), trial);
        other.advance(Long.MAX_VALUE, Long.MAX_VALUE);
        assertEquals(whole.outcome(), other.outcome(), trial);
        assertEquals(whole.expanded(), other.expanded(), trial);
        if (slow.found == null) {
            failed++;
            return;
        }
        found++;
        hard += slow.expanded > 20 && whole.transfer().poses().size() > 3 ? 1 : 0;
        assertEquals(slow.cost(), whole.cost(), trial);
        assertEquals(slow.found.pose(), whole.transfer().last(), trial);
        assertEquals(slow.cost(), slow.cost(whole.transfer().poses()), trial);
        assertEquals(slow.found.stand(), whole.transfer().to(), trial);
        assertEquals(whole.transfer(), sliced.transfer(), trial);
        assertEquals(whole.transfer(), other.transfer(), trial);
    }
}
