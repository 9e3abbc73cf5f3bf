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
 */
public final class CrowdBench {
    private static final int WARM = 100;
    private static final int STEPS = 100;

    private CrowdBench() {}

    /** Runs all, or the numbers of agents given. */
    public static void main(String[] arguments) {
        List<Integer> sizes = new ArrayList<>();
        for (String argument : arguments) {
            sizes.add(Integer.valueOf(argument));
        }
        System.out.println("scene,agents,one_thread_k,us_per_agent,visits,two_threads_k,floor_k,floor_visits");
        measure("warm", scene(1_000, 1, false));
        for (int n : sizes.isEmpty() ? List.of(100, 1_000, 10_000) : sizes) {
            measure("open", scene(n, 0.25, false));
            measure("dense", scene(n, 2, false));
            measure("town", scene(n, 0.5, true));
        }
    }

    /** Makes a square world with a density in agents per square metre of free ground; four flows cross it. */
    static Scene scene(int n, double density, boolean town) {
        double free = town ? 0.56 : 1;
        double size = Math.max(8, Math.sqrt(n / density / free));
        List<Obstacle> houses = new ArrayList<>();
        for (double x = 5; town && x + 10 < size; x += 15) {
            for (double y = 5; y + 10 < size; y += 15) {
                houses.add(new Obstacle(
                        "h" + houses.size(), "", Polygon.rectangle(x, y, x + 10, y + 10), 0, 5, false, 20, ""));
            }
        }
        List<CrowdGroup> groups = new ArrayList<>();
        double[][] goals = {{size - 1, size / 2}, {size / 2, size - 1}, {1, size / 2}, {size / 2, 1}};
        for (int k = 0; k < 4; k++) {
            double gx = town && k % 2 == 1 ? 2 + 15 * Math.floor(size / 30) : goals[k][0];
            double gy = town && k % 2 == 0 ? 2 + 15 * Math.floor(size / 30) : goals[k][1];
            groups.add(CrowdGroup.of(
                    "g" + k,
                    Place.of(Math.min(gx, size - 1), Math.min(gy, size - 1)),
                    new CrowdGroup.Members(
                            n / 4, Polygon.rectangle(0, 0, size, size), OptionalDouble.empty(), 0.2, 1.3)));
        }
        Crowd crowd = Crowd.of("crowd", groups).lasting(3_600);
        return new Scene(
                "", new World(size, size, size > 100 ? 0.2 : 0.1), houses, List.of(), List.of(), List.of(crowd));
    }

    private static void measure(String name, Scene scene) {
        Crowd crowd = (Crowd) scene.tasks().get(0);
        CrowdEngine one = new CrowdEngine(scene, crowd, Sweep.alone());
        one.step(WARM);
        PlainFlock floor =
                new PlainFlock(one.agents().x, one.agents().y, scene.world().width(), 2);
        double oneSeconds = Double.POSITIVE_INFINITY;
        for (int round = 0; round < 3; round++) {
            long begin = cpu();
            one.step(STEPS);
            oneSeconds = Math.min(oneSeconds, (cpu() - begin) * 1e-9);
        }
        ForkJoinPool pool = new ForkJoinPool(2);
        CrowdEngine two = new CrowdEngine(scene, crowd, Sweep.on(pool));
        two.step(WARM);
        double twoSeconds = Double.POSITIVE_INFINITY;
        for (int round = 0; round < 3; round++) {
            long begin = System.nanoTime();
            two.step(STEPS);
            twoSeconds = Math.min(twoSeconds, (System.nanoTime() - begin) * 1e-9);
        }
        pool.shutdown();
        floor.run(WARM);
        double floorSeconds = Double.POSITIVE_INFINITY;
        for (int round = 0; round < 3; round++) {
            long begin = cpu();
            floor.run(STEPS);
            floorSeconds = Math.min(floorSeconds, (cpu() - begin) * 1e-9);
        }
        double moves = (double) one.agents().count * STEPS;
        System.out.println(String.format(
                Locale.ROOT,
                "%s,%d,%.0f,%.3f,%.1f,%.0f,%.0f,%.1f",
                name,
                one.agents().count,
                moves / oneSeconds / 1_000,
                oneSeconds / moves * 1e6,
                one.visitsPerMove(),
                moves / twoSeconds / 1_000,
                moves / floorSeconds / 1_000,
                floor.visitsPerMove()));
    }

    private static long cpu() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }
}
