package troupe.bench;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.concurrent.ForkJoinPool;
import troupe.crowd.CrowdEngine;
import troupe.crowd.flock.Sweep;
import troupe.geometry.Polygon;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Measures crowds of 100, 1,000 and 10,000 agents in the open, dense, and in a town with streets, on one thread (by its
 * CPU time) and on two (by the clock), beside a plain-array flock of the three forces alone. Prints thousand
 * agent-steps per second, microseconds per agent and step, and neighbours looked at.
 *
 * <p>Like is compared with like: four flows cross a square towards goals outside it, so that nobody arrives, all for
 * the same {@value #WARM} and {@value #STEPS} steps, a small crowd from so many seeds that as many agent-steps are
 * timed as of the largest; and the square of a small crowd, which has more rim for its size, is changed until as many
 * neighbours are looked at, within {@value #ALIKE}.
 */
public final class CrowdBench {
    private static final int WARM = 25;
    private static final int STEPS = 100;
    private static final int LARGEST = 10_000;
    private static final int ROUNDS = 3;
    private static final double ALIKE = 0.02;
    /** Metres from the square to the goals and to the end of the world. */
    private static final double MARGIN = 14;

    private static final double BLOCK = 15;
    private static final double STREET = 5;

    private CrowdBench() {}

    /** A kind of scene: agents per square metre of free ground, and whether there are houses. */
    record Kind(String name, double density, boolean town) {}

    private static final List<Kind> KINDS =
            List.of(new Kind("open", 0.25, false), new Kind("dense", 1.5, false), new Kind("town", 0.5, true));

    /** Runs all, or the kinds named. */
    public static void main(String[] arguments) {
        List<String> names = List.of(arguments);
        for (int round = 0; round < ROUNDS; round++) {
            run(KINDS.get(2), 1_000, 40, Sweep.alone());
        }
        System.out.println("scene,agents,one_thread_k,us_per_agent,visits,two_threads_k,floor_k,floor_visits");
        for (Kind kind : KINDS) {
            if (!names.isEmpty() && !names.contains(kind.name())) {
                continue;
            }
            double most = side(kind, LARGEST);
            double visits = run(kind, LARGEST, most, Sweep.alone()).visits();
            for (int n : new int[] {100, 1_000}) {
                measure(kind, n, calibrated(kind, n, visits));
            }
            measure(kind, LARGEST, most);
        }
    }

    /** Makes a town with streets that so many cross. */
    static Scene town(int n) {
        return scene(KINDS.get(2), n, side(KINDS.get(2), n), 1);
    }

    /** Returns the side in metres of the square on which so many have the density of a kind. */
    static double side(Kind kind, int n) {
        double street = STREET / BLOCK;
        double free = kind.town() ? 1 - (1 - street) * (1 - street) : 1;
        return Math.sqrt(n / kind.density() / free);
    }

    private static double calibrated(Kind kind, int n, double visits) {
        double side = side(kind, n);
        for (int attempt = 0; attempt < 12; attempt++) {
            double seen = run(kind, n, side, Sweep.alone()).visits();
            if (Math.abs(seen / visits - 1) < ALIKE) {
                return side;
            }
            side *= Math.sqrt(seen / visits);
        }
        return side;
    }

    /** Makes a world with a square in its middle, in which the members of four flows stand; each crosses it. */
    static Scene scene(Kind kind, int n, double side, long seed) {
        double size = side + 2 * MARGIN;
        double goal = 2;
        List<Obstacle> houses = new ArrayList<>();
        if (kind.town()) {
            int blocks = 2 * (int) Math.ceil((size - STREET) / 2 / BLOCK);
            size = blocks * BLOCK + STREET;
            goal = STREET / 2;
            for (int b = 0; b < blocks * blocks; b++) {
                double x = STREET + b % blocks * BLOCK;
                double y = STREET + b / blocks * BLOCK;
                Polygon house = Polygon.rectangle(x, y, x + BLOCK - STREET, y + BLOCK - STREET);
                houses.add(new Obstacle("h" + b, "", house, 0, 5, false, 20, ""));
            }
        }
        double middle = size / 2;
        // a town's square lies around a crossing, so that a small one holds its share of street
        double low = middle - side / 2;
        double[][] goals = {{size - goal, middle}, {middle, size - goal}, {goal, middle}, {middle, goal}};
        List<CrowdGroup> groups = new ArrayList<>();
        for (int k = 0; k < goals.length; k++) {
            Polygon square = Polygon.rectangle(low, low, low + side, low + side);
            groups.add(CrowdGroup.of(
                    "g" + k,
                    Place.of(goals[k][0], goals[k][1]),
                    new CrowdGroup.Members(n / 4, square, OptionalDouble.empty(), 0.2, 1.3)));
        }
        Crowd crowd = Crowd.of("crowd", groups).lasting(3_600).seeded(seed);
        return new Scene("", new World(size, size, 0.2), houses, List.of(), List.of(), List.of(crowd));
    }

    /** What a number of agents took: seconds of processor time and by the clock, and how many each looked at. */
    private record Result(double cpu, double clock, double visits, CrowdEngine last, double width) {}

    private static Result run(Kind kind, int n, double side, Sweep sweep) {
        double cpu = 0;
        double clock = 0;
        double visits = 0;
        int runs = LARGEST / n;
        CrowdEngine engine = null;
        double width = 0;
        for (int seed = 1; seed <= runs; seed++) {
            Scene scene = scene(kind, n, side, seed);
            engine = new CrowdEngine(scene, (Crowd) scene.tasks().get(0), sweep);
            width = scene.world().width();
            engine.step(WARM);
            if (!engine.outcome().isRunning()) {
                throw new IllegalStateException(engine.outcome().toString());
            }
            long begin = System.nanoTime();
            long own = cpu();
            engine.step(STEPS);
            cpu += (cpu() - own) * 1e-9;
            clock += (System.nanoTime() - begin) * 1e-9;
            visits += engine.visitsPerMove() / runs;
        }
        return new Result(cpu, clock, visits, engine, width);
    }

    private static void measure(Kind kind, int n, double side) {
        double one = Double.POSITIVE_INFINITY;
        double two = Double.POSITIVE_INFINITY;
        double floor = Double.POSITIVE_INFINITY;
        Result result = null;
        ForkJoinPool pool = new ForkJoinPool(2);
        for (int round = 0; round < ROUNDS; round++) {
            result = run(kind, n, side, Sweep.alone());
            one = Math.min(one, result.cpu());
            two = Math.min(two, run(kind, n, side, Sweep.on(pool)).clock());
        }
        pool.shutdown();
        CrowdEngine last = result.last();
        PlainFlock flock = new PlainFlock(last.agents().x, last.agents().y, result.width(), 2);
        int steps = STEPS * (LARGEST / n);
        flock.run(STEPS);
        for (int round = 0; round < ROUNDS; round++) {
            long begin = cpu();
            flock.run(steps);
            floor = Math.min(floor, (cpu() - begin) * 1e-9);
        }
        double moves = (double) n * steps;
        System.out.println(String.format(
                Locale.ROOT,
                "%s,%d,%.0f,%.3f,%.1f,%.0f,%.0f,%.1f",
                kind.name(),
                n,
                moves / one / 1_000,
                one / moves * 1e6,
                result.visits(),
                moves / two / 1_000,
                moves / floor / 1_000,
                flock.visitsPerMove()));
    }

    private static long cpu() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }
}
