package troupe.bench;

import java.nio.file.Path;
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
import troupe.run.Run;
import troupe.scene.Journey;
import troupe.scene.Ordering;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;

/** Measures whole plans of sample scenes, warm: layers, region, search, smoothing and frames. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
public class JourneyBench {
    /** Name of the scene. */
    @Param({"courtyard", "layers", "apartment", "two-ways", "chain"})
    public String scene;

    private Scene optimal;
    private Scene paper;
    private String task;

    /** Reads the scene. */
    @Setup
    public void setUp() throws Exception {
        optimal = SceneXml.read(Path.of("scenes/unified/" + scene + ".xml")).scene();
        Task first = optimal.tasks().get(0);
        task = first.id();
        paper = optimal.with(((Journey) first).with(new Ordering.Paper(1, 1)));
    }

    /** Measures a plan of least cost. */
    @Benchmark
    public Run optimal() {
        return Tasks.start(optimal, task).finish();
    }

    /** Measures a plan in the published order, which needs the NF2 potential too. */
    @Benchmark
    public Run paper() {
        return Tasks.start(paper, task).finish();
    }
}
