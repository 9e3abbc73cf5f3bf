package troupe.bench;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Random;
import troupe.crowd.CrowdEngine;
import troupe.crowd.flock.Sweep;
import troupe.geometry.Polygon;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/**
 * Repeats the test of the paper (Crowd section 4.2, figure 8): agents and goals at random in the corridor that forks, 20
 * to 150 by tens, ten simulated seconds each on one thread, the first second left out. Prints frames per second of
 * processor time; nothing is drawn.
 */
public final class PaperPace {
    private static final int FIRST = 25;
    private static final int TIMED = 225;

    private PaperPace() {}

    /** Runs the test. */
    public static void main(String[] arguments) throws Exception {
        Scene fork = SceneXml.read(Path.of("scenes/crowd/fork.xml")).scene();
        for (long seed = 1; seed <= 5; seed++) {
            pace(fork, 150, seed);
        }
        System.out.println("agents,frames_per_second");
        for (int n = 20; n <= 150; n += 10) {
            System.out.println(String.format(Locale.ROOT, "%d,%.0f", n, pace(fork, n, 1)));
        }
    }

    private static double pace(Scene fork, int n, long seed) {
        CrowdEngine engine = engine(fork, n, seed);
        engine.step(1 + FIRST);
        long begin = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        engine.step(TIMED);
        return TIMED / ((ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - begin) * 1e-9);
    }

    private static CrowdEngine engine(Scene fork, int n, long seed) {
        Random random = new Random(seed);
        List<CrowdGroup> groups = new ArrayList<>();
        while (groups.size() < n) {
            double x = random.nextDouble() * fork.world().width();
            double y = 0.3 + random.nextDouble() * (fork.world().depth() - 0.6);
            boolean free = fork.obstacles().stream()
                    .allMatch(o -> !o.outline().contains(x, y) && o.outline().distance(x, y) > 0.3);
            if (free) {
                Polygon anywhere = Polygon.rectangle(4, 0, 16, 30);
                groups.add(CrowdGroup.of(
                        "g" + groups.size(),
                        Place.of(x, y),
                        new CrowdGroup.Members(1, anywhere, OptionalDouble.empty(), 0.2, 1.3)));
            }
        }
        Crowd crowd = Crowd.of("crowd", groups).lasting(3_600);
        Scene scene = new Scene("", fork.world(), fork.obstacles(), List.of(), List.of(), List.of(crowd));
        return new CrowdEngine(scene, crowd, Sweep.alone());
    }
}
