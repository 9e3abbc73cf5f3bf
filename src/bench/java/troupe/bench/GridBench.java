package troupe.bench;

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
import troupe.grid.field.Nf2;
import troupe.grid.layer.Layers;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.scene.Actor;
import troupe.scene.Journey.Spread;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Measures the stages of the grid core on a hall with sixty obstacles, and the floors that they are made of.
 * Names of floors begin with {@code floor}: the same work on plain arrays, without layers, links or classes.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(value = 1, jvmArgsAppend = "-Xmx6g")
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class GridBench {
    /** Cells along each side. */
    @Param({"256", "1024", "4096"})
    public int size;

    private Scene scene;
    private Actor actor;
    private Region region;
    private int goal;
    private Floors floors;

    /** Builds the inputs of the stages. */
    @Setup
    public void setUp() {
        scene = GeneratedScenes.hall(size);
        actor = Actor.standard("a");
        region = Region.of(scene, actor);
        goal = -1;
        for (double x = GeneratedScenes.SIDE / 2;
                goal < 0 || !region.open(goal);
                x += scene.world().cell()) {
            goal = region.locate(Place.of(x, GeneratedScenes.SIDE / 2));
        }
        floors = new Floors(size, scene);
    }

    /** Measures spans and layers. */
    @Benchmark
    public Layers layering() {
        return new RegionBuilder(scene, actor).layers();
    }

    /** Measures spans, clearance, classes, crossings and legal steps. */
    @Benchmark
    public Region region() {
        return new RegionBuilder(scene, actor).region();
    }

    /** Measures skeleton and potential. */
    @Benchmark
    public Nf2 nf2() {
        return new Nf2(region).compute(goal, Spread.BREADTH);
    }

    /** Measures layers, region, skeleton and potential together. */
    @Benchmark
    public Nf2 everything() {
        RegionBuilder builder = new RegionBuilder(scene, actor);
        builder.layers();
        return new Nf2(builder.region()).compute(goal, Spread.BREADTH);
    }

    /** Measures the scanline fill of all outlines. */
    @Benchmark
    public byte[] floorPolygonFill() {
        return floors.fillPolygons();
    }

    /** Measures a breadth-first fill over four neighbours. */
    @Benchmark
    public int[] floorBreadthFirstFill() {
        return floors.breadthFirst();
    }

    /** Measures the exact Euclidean distance transform. */
    @Benchmark
    public int[] floorDistanceTransform() {
        return floors.distances(floors.solid());
    }

    /** Measures an opening by a disc: two distance transforms and their cuts. */
    @Benchmark
    public byte[] floorDiscOpening() {
        return floors.open(0.7 / scene.world().cell());
    }

    /** Measures a wavefront with origins, the ridge between them, and the potential along it and beside it. */
    @Benchmark
    public int[] floorSkeletonAndPotential() {
        return floors.skeletonAndPotential();
    }

    /** Measures one pass over memory: a copy of four bytes per cell. */
    @Benchmark
    public int[] floorMemoryCopy() {
        return floors.copy();
    }
}
