package troupe.bench;

import java.lang.ref.Reference;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import troupe.geometry.Polygon;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Measures patches of a region: an obstacle of 2 m x 2 m in the hall of sixty obstacles, 25.6 m wide, is moved by a few
 * centimetres, as when it is dragged, or taken away. The main method prints instead what a hundred such
 * regions take in memory, lists of neighbours included.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(value = 1, jvmArgsAppend = "-Xmx2g")
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class PatchBench {
    private static final int POSES = 100;

    /** Cells along each side. */
    @Param({"256", "1024"})
    public int size;

    /** Height of the obstacle in metres: too high to vault, and low enough. */
    @Param({"2.0", "0.8"})
    public double height;

    private Scene scene;
    private Actor actor;
    private Region base;
    private int obstacle;
    private Polygon[] poses;
    private int next;

    /** Builds the region of the scene. */
    @Setup
    public void setUp() {
        Scene hall = GeneratedScenes.hall(size);
        List<Obstacle> obstacles = new ArrayList<>(hall.obstacles());
        Polygon outline = Polygon.rectangle(12, 12, 14, 14);
        obstacle = obstacles.size();
        obstacles.add(new Obstacle("crate", "", outline, 0, height, true, Obstacle.DEFAULT_MASS, ""));
        scene = new Scene("", hall.world(), obstacles, List.of(), List.of(), List.of());
        actor = Actor.standard("a");
        base = Region.of(scene, actor);
        poses = new Polygon[POSES];
        for (int i = 0; i < POSES; i++) {
            poses[i] = outline.shifted(0.03 * (i - POSES / 2), 0.02 * i);
        }
    }

    private Polygon pose() {
        next = (next + 1) % POSES;
        return poses[next];
    }

    /** Measures moving the obstacle. */
    @Benchmark
    public Region with() {
        return base.with(obstacle, pose());
    }

    /** Measures taking the obstacle away. */
    @Benchmark
    public Region without() {
        return base.without(obstacle);
    }

    /** Measures building everything again. */
    @Benchmark
    public Region whole() {
        return Region.of(scene, actor);
    }

    /** Measures the region that bounds all placements, built with the base. */
    @Benchmark
    public Region widest() {
        return new RegionBuilder(scene, actor).widest();
    }

    /** Prints how much memory a hundred patched regions take beside the one they come from. */
    public static void main(String[] arguments) {
        for (double height : new double[] {2.0, 0.8}) {
            PatchBench bench = new PatchBench();
            bench.size = 256;
            bench.height = height;
            bench.setUp();
            long before = used();
            Region[] patched = new Region[POSES];
            int[] targets = new int[Region.MAX_NEIGHBOURS];
            int[] directions = new int[Region.MAX_NEIGHBOURS];
            for (int i = 0; i < POSES; i++) {
                patched[i] = bench.base.with(bench.obstacle, bench.poses[i]);
                for (int q = 0; q < patched[i].size(); q++) {
                    patched[i].neighbours(q, targets, directions);
                }
            }
            double taken = (used() - before) / 1e6;
            Reference.reachabilityFence(patched);
            System.out.printf("%d regions of 256 x 256 cells, obstacle %.1f m high: %.1f MB%n", POSES, height, taken);
        }
    }

    private static long used() {
        for (int i = 0; i < 4; i++) {
            System.gc();
        }
        Runtime runtime = Runtime.getRuntime();
        return runtime.totalMemory() - runtime.freeMemory();
    }
}
