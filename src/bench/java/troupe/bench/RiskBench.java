package troupe.bench;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import troupe.geometry.Polygon;
import troupe.risk.EncounterEngine;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

/** Measures a step with ten avatars on 256 x 256 cells, and the way from nothing to the first plan. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 2)
public class RiskBench {
    private static final int WARM = 15;
    private static final int ROUNDS = 25;

    private Scene scene;
    private Encounter encounter;
    private EncounterEngine engine;

    /** Makes a square of 12.8 m with four blocks, and avatars that cross it in all directions. */
    @Setup
    public void setUp() {
        List<Avatar> avatars = new ArrayList<>();
        for (int k = 0; k < 10; k++) {
            double angle = 2 * Math.PI * k / 10;
            Place from = Place.of(6.4 + 5 * StrictMath.cos(angle), 6.4 + 5 * StrictMath.sin(angle));
            Place to = Place.of(6.4 - 5 * StrictMath.cos(angle + 0.6), 6.4 - 5 * StrictMath.sin(angle + 0.6));
            List<Avatar.Head> heads =
                    List.of(new Avatar.Head(to, OptionalDouble.empty()), new Avatar.Head(from, OptionalDouble.empty()));
            avatars.add(Avatar.of("a" + k, new Avatar.Script(from, 0.8 + 0.05 * k, heads)));
        }
        List<Obstacle> blocks = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            double x = k % 2 == 0 ? 3 : 9;
            double y = k < 2 ? 3 : 9;
            Polygon box = Polygon.rectangle(x, y, x + 0.8, y + 0.8);
            blocks.add(new Obstacle("b" + k, "", box, 0, 2, false, Obstacle.DEFAULT_MASS, ""));
        }
        encounter = Encounter.of("meet", "ann", Place.of(0.8, 6), Place.of(12, 6.8), avatars);
        scene = new Scene(
                "",
                new World(12.8, 12.8, 0.05),
                blocks,
                List.of(),
                List.of(Actor.walker("ann", 0.25, 0.1)),
                List.of(encounter));
        engine = EncounterEngine.of(scene, encounter);
    }

    /** Measures one step of the simulation; at the end of an encounter the next begins, which the median does not see. */
    @Benchmark
    public Outcome step() {
        if (!engine.outcome().isRunning()) {
            engine = EncounterEngine.of(scene, encounter);
        }
        return engine.step(1);
    }

    /** Measures region, potential, prediction and the first plan. */
    @Benchmark
    public Outcome firstPlan() {
        return EncounterEngine.of(scene, encounter).step(1);
    }

    /** Prints the processor time of steps and of first plans, which other work on the machine disturbs less. */
    public static void main(String[] arguments) {
        RiskBench bench = new RiskBench();
        bench.setUp();
        List<Double> steps = new ArrayList<>();
        List<Double> plans = new ArrayList<>();
        for (int round = -WARM; round < ROUNDS; round++) {
            bench.engine = EncounterEngine.of(bench.scene, bench.encounter);
            for (boolean first = true; bench.engine.outcome().isRunning(); first = false) {
                long before = processorNanos();
                bench.engine.step(1);
                double took = (processorNanos() - before) / 1e6;
                if (round >= 0) {
                    (first ? plans : steps).add(took);
                }
            }
        }
        print("step", steps);
        print("first plan", plans);
    }

    private static void print(String what, List<Double> took) {
        Collections.sort(took);
        double most = took.get((int) (0.99 * took.size()));
        System.out.printf(
                "%s, %d times: median %.2f ms, 99 %% %.2f ms%n", what, took.size(), took.get(took.size() / 2), most);
    }

    private static long processorNanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }
}
