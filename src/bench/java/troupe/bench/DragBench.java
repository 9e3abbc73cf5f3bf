package troupe.bench;

import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
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
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import troupe.app.document.SceneDocument;
import troupe.app.plan.Plan;
import troupe.app.plan.PlanningSteps;
import troupe.app.session.SceneFiles;
import troupe.app.session.Session;
import troupe.geometry.Pose;
import troupe.grid.region.Groundworks;
import troupe.run.Engine;
import troupe.run.view.Overlay;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;

/**
 * Measures the studio's answer while an obstacle is dragged: from the edit of the document on the event thread
 * to the plan of that very moment being told there. The obstacle goes round in a small circle, so that it stays
 * in the way and has to be moved in every plan. Views that nobody waits for are made between two moments, as
 * in the window, and delay the next one.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 2)
public class DragBench {
    private static final double RADIUS_M = 0.04;
    private static final int MOMENTS = 24;

    /** Name of the scene and, after a colon, the id of what is dragged. */
    @Param({"courtyard:crate", "two-ways:cabinet", "three-ways:crate", "apartment:coffee-table"})
    public String dragged;

    /** Whether the views are made, too. */
    @Param({"true", "false"})
    public boolean views;

    private final LinkedBlockingQueue<Plan> told = new LinkedBlockingQueue<>();
    private Session session;
    private Scene scene;
    private Obstacle obstacle;
    private int moment;

    /** Opens the scene and plans it. */
    @Setup
    public void setUp() throws Exception {
        String[] words = dragged.split(":");
        scene = SceneXml.read(Path.of("scenes/unified/" + words[0] + ".xml")).scene();
        obstacle = scene.obstacle(words[1]).orElseThrow();
        EventQueue.invokeAndWait(() -> {
            session = new Session(
                    new SceneDocument(scene, Optional.empty()),
                    new Steps(views, new Groundworks()),
                    NO_FILES,
                    EventQueue::invokeLater);
            session.plans().add(told::add);
        });
    }

    /** Ends the background thread. */
    @TearDown
    public void tearDown() throws Exception {
        EventQueue.invokeAndWait(session::close);
    }

    /** Moves the obstacle a little and waits for the plan. */
    @Benchmark
    public Plan drag() throws Exception {
        double angle = 2 * Math.PI * (moment++ % MOMENTS) / MOMENTS;
        double x = obstacle.outline().centroid().x() + RADIUS_M * Math.cos(angle);
        double y = obstacle.outline().centroid().y() + RADIUS_M * Math.sin(angle);
        Scene moved = scene.with(obstacle.withOutline(obstacle.outline().at(new Pose(x, y, 0))));
        EventQueue.invokeLater(() -> session.document().preview(moved));
        Plan plan = told.take();
        while (plan.snapshot().scene() != moved) {
            plan = told.take();
        }
        return plan;
    }

    static final SceneFiles NO_FILES = new SceneFiles() {
        @Override
        public Scene read(Path file) throws SceneException {
            throw new UnsupportedOperationException("the benchmark reads no file");
        }

        @Override
        public Scene convert(Path file) {
            throw new UnsupportedOperationException("the benchmark reads no file");
        }

        @Override
        public void write(Scene written, Path file) {
            throw new UnsupportedOperationException("the benchmark writes no file");
        }
    };

    /** The steps of the studio. */
    record Steps(boolean views, Groundworks kept) implements PlanningSteps {
        @Override
        public List<Problem> check(Scene checked) {
            return SceneChecks.check(checked);
        }

        @Override
        public List<Problem> inspect(Scene checked) {
            return List.of();
        }

        @Override
        public Engine start(Scene planned, String task) {
            return Tasks.start(planned, task, kept);
        }

        @Override
        public List<Overlay> overlays(
                Scene planned, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
            return views ? engine.overlays(chosen, wanted) : List.of();
        }
    }
}
