package troupe.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.manipulation.ConfigurationSpace;
import troupe.unified.manipulation.ExpectedPath;
import troupe.unified.manipulation.Instance;
import troupe.unified.manipulation.Prices;
import troupe.unified.manipulation.Question;
import troupe.unified.obstacle.Grip;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;

/**
 * Measures an expansion, all ten moves, of the search for where to put an obstacle: ns per expansion over
 * the first 10,000. The path bars every pose that can be reached so soon. {@code open}: nothing near;
 * {@code near}: blocks stand around so that hardly a pose is out of their reach.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class InstanceBench {
    private static final int EXPANSIONS = 10_000;

    /** What stands around. */
    @Param({"open", "near"})
    public String place;

    private Movable movable;
    private Surroundings surroundings;
    private ConfigurationSpace barred;
    private Prices prices;
    private Region without;
    private int trigger;

    /** Builds the scene. */
    @Setup
    public void setUp() {
        List<Obstacle> obstacles = new ArrayList<>();
        obstacles.add(block(Polygon.rectangle(12, 12, 13, 12.6), true));
        if (place.equals("near")) {
            Random random = new Random(4);
            for (int n = 0; n < 200; n++) {
                double x = 25 * random.nextDouble();
                double y = 25 * random.nextDouble();
                if (Math.hypot(x - 12.5, y - 12.3) > 1.4) {
                    obstacles.add(block(
                            Polygon.rectangle(x - 0.2, y - 0.2, x + 0.2, y + 0.2)
                                    .at(new Pose(x, y, random.nextDouble())),
                            false));
                }
            }
        }
        Actor actor = Actor.standard("a");
        Scene scene = new Scene("", new World(25, 25, 0.1), obstacles, List.of(), List.of(actor), List.of());
        movable = Movable.of(scene, 24).get(0);
        surroundings = new Surroundings(scene);
        GridFrame frame = GridFrame.of(scene.world());
        int[] cells = new int[frame.size()];
        Arrays.setAll(cells, c -> c);
        double[] radii = new double[cells.length];
        Arrays.fill(radii, 0.25);
        barred = new ConfigurationSpace(movable, new ExpectedPath(frame, 1.7, cells, new double[cells.length], radii));
        prices = new Prices(600L << 20, (long) (600 * Math.sqrt(2) * (1 << 20)), 523L << 20, 100L << 20, 141L << 20);
        without = new RegionBuilder(scene, actor).region().without(0);
        trigger = frame.cellAt(11.65, 12.35);
        for (int k = 0; k < 24; k++) {
            barred.contains(0, 0, k);
        }
    }

    private static Obstacle block(Polygon outline, boolean movable) {
        return new Obstacle("o", "", outline, 0, 1, movable, 20, "");
    }

    private Instance run(Optional<Grip> grip) {
        Instance instance = new Instance(new Question(movable, surroundings, barred, prices, grip, trigger));
        if (instance.advance(EXPANSIONS, Long.MAX_VALUE) != EXPANSIONS) {
            throw new IllegalStateException("ended after " + instance.expanded());
        }
        return instance;
    }

    /** Measures the obstacle alone. */
    @Benchmark
    @OperationsPerInvocation(EXPANSIONS)
    public Instance free() {
        return run(Optional.empty());
    }

    /** Measures the obstacle and the actor that holds it. */
    @Benchmark
    @OperationsPerInvocation(EXPANSIONS)
    public Instance grip() {
        return run(Optional.of(new Grip(movable, surroundings, without, trigger, (pose, stand) -> true)));
    }

    /** Measures the first expansion, with all that has to be prepared for it but the surroundings. */
    @Benchmark
    public Instance establish() {
        Grip grip = new Grip(movable, surroundings, without, trigger, (pose, stand) -> true);
        Instance instance =
                new Instance(new Question(movable, surroundings, barred, prices, Optional.of(grip), trigger));
        instance.advance(1, Long.MAX_VALUE);
        return instance;
    }

    /** Measures the surroundings of a space in which something has been moved, and their first use. */
    @Benchmark
    public Instance surround() {
        Surroundings other = surroundings.with(0, movable.outline(0));
        Instance instance = new Instance(new Question(movable, other, barred, prices, Optional.empty(), trigger));
        instance.advance(1, Long.MAX_VALUE);
        return instance;
    }

    /** Measures a path of 100 cells and the poses of one heading that it bars. */
    @Benchmark
    public boolean stamp() {
        GridFrame frame = without.frame();
        int[] cells = new int[100];
        Arrays.setAll(cells, c -> frame.index(50 + c, 75 + c));
        double[] radii = new double[cells.length];
        Arrays.fill(radii, 0.25);
        ExpectedPath path = new ExpectedPath(frame, 1.7, cells, new double[cells.length], radii);
        return new ConfigurationSpace(movable, path).contains(0, 0, 1);
    }
}
