package troupe.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import troupe.crowd.CrowdEngine;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Sweep;
import troupe.geometry.Polygon;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Crowd;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.setting.Settings;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.search.Outcome;

/**
 * Makes the tables of {@code docs/crowd.md}: {@code fork}, {@code narrow-bridge} and {@code two-ways} for so many seeds,
 * and {@code gate} for door widths from 0.8 to 2.4 m and so many seeds, with its plot where a file is named.
 */
public final class CrowdTables {
    private static final double[] WIDTHS = {0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4};

    private CrowdTables() {}

    /** Runs a table: its name, the number of seeds and, of the gate, the file of its plot. */
    public static void main(String[] arguments) throws IOException, SceneException {
        String name = arguments[0];
        int seeds = Integer.parseInt(arguments[1]);
        if (name.equals("gate")) {
            double[] flows = gate(seeds);
            if (arguments.length > 2) {
                Files.writeString(Path.of(arguments[2]), FlowPlot.svg(WIDTHS, flows));
            }
            return;
        }
        Scene scene = SceneXml.read(Path.of("scenes/crowd/" + name + ".xml")).scene();
        if (name.equals("fork")) {
            fork("with relation vectors", scene, seeds);
            fork("all vectors (1, 1, 1)", alike(scene), seeds);
            return;
        }
        boolean ways = name.equals("two-ways");
        for (String value : ways ? List.of("static", "tree", "free") : List.of("anticipate", "paper")) {
            times(value, set(scene, ways ? "split" : "motion", value), seeds);
        }
    }

    private static Scene set(Scene scene, String key, String value) {
        return Settings.apply(scene, scene.tasks().get(0).id(), key, value);
    }

    private static Scene alike(Scene scene) {
        Scene alike = scene;
        for (int depth = 0; depth <= 2; depth++) {
            for (String force : List.of("cohesion", "alignment", "separation")) {
                alike = set(alike, "relation." + depth + "." + force, "1");
            }
        }
        return alike;
    }

    private static Run run(Scene scene, int seed) {
        Scene seeded = set(scene, "seed", Integer.toString(seed));
        return new CrowdEngine(seeded, (Crowd) seeded.tasks().get(0), Sweep.alone()).finish();
    }

    /** Prints how many seeds part, one group to each side of the island, and who goes where. */
    private static void fork(String name, Scene scene, int seeds) {
        int parted = 0;
        int arrived = 0;
        StringBuilder sides = new StringBuilder();
        for (int seed = 1; seed <= seeds; seed++) {
            Run run = run(scene, seed);
            int blue = left(run, "blue");
            int black = left(run, "black");
            parted += Math.abs(blue - black) == 10 ? 1 : 0;
            arrived += run.outcome().equals(Outcome.FOUND) ? 1 : 0;
            sides.append(' ').append(blue).append('/').append(black);
        }
        System.out.println(name + ": parted in " + parted + " of " + seeds + " seeds, all arrive in " + arrived
                + "; to the left, blue/black:" + sides);
    }

    private static int left(Run run, String group) {
        int x = run.frames().channel(group, "x");
        int y = run.frames().channel(group, "y");
        int count = 0;
        for (int m = 0; m < 10; m++) {
            int frame = 0;
            while (frame < run.frames().count() - 1 && run.frames().value(frame, y, m) < 16.5) {
                frame++;
            }
            count += run.frames().value(frame, x, m) < 10 ? 1 : 0;
        }
        return count;
    }

    private static void times(String name, Scene scene, int seeds) {
        int found = 0;
        long arrived = 0;
        double mean = 0;
        double last = 0;
        double latest = 0;
        for (int seed = 1; seed <= seeds; seed++) {
            Run run = run(scene, seed);
            Report report = run.report();
            double end = (double) report.values().get("last_arrival_s");
            found += run.outcome().equals(Outcome.FOUND) ? 1 : 0;
            arrived += (long) report.values().get("arrived");
            mean += (double) report.values().get("mean_travel_s") / seeds;
            last += end / seeds;
            latest = Math.max(latest, end);
        }
        System.out.println(String.format(
                Locale.ROOT,
                "%s: all arrive in %d of %d seeds, agents %d, mean travel %.1f s, last %.1f s, latest %.1f s",
                name,
                found,
                seeds,
                arrived,
                mean,
                last,
                latest));
    }

    /** Prints a line for each width and seed; returns the mean flow in agents per second for each width. */
    private static double[] gate(int seeds) throws IOException, SceneException {
        double[] flows = new double[WIDTHS.length];
        System.out.println("door_m,seed,per_s,per_m_and_s,passed,last_passes_s,all_settled_s,outcome");
        for (int w = 0; w < WIDTHS.length; w++) {
            for (int seed = 1; seed <= seeds; seed++) {
                flows[w] += gate(WIDTHS[w], seed) / seeds;
            }
        }
        return flows;
    }

    private static double gate(double width, int seed) throws IOException, SceneException {
        Scene scene = SceneXml.read(Path.of("scenes/crowd/gate.xml")).scene();
        List<Obstacle> walls = new ArrayList<>();
        for (Obstacle wall : scene.obstacles()) {
            boolean south = wall.id().equals("wall-south");
            Polygon outline = south
                    ? Polygon.rectangle(22, 0, 22.4, 12 - width / 2)
                    : Polygon.rectangle(22, 12 + width / 2, 22.4, 24);
            walls.add(new Obstacle(wall.id(), "", outline, 0, wall.height(), false, 20, ""));
        }
        Crowd crowd = ((Crowd) scene.tasks().get(0)).lasting(1_400).seeded(seed);
        Scene door = new Scene("", scene.world(), walls, List.of(), List.of(), List.of(crowd));
        CrowdEngine engine = new CrowdEngine(door, crowd, Sweep.alone());
        int[] through = new int[36_001];
        int last = 0;
        int frame = 0;
        while (engine.step(1).isRunning()) {
            frame++;
            through[frame] = through(engine.agents());
            last = through[frame] > through[frame - 1] ? frame : last;
        }
        double flow = (through[1_750] - through[500]) / 50.0;
        System.out.println(String.format(
                Locale.ROOT,
                "%.1f,%d,%.2f,%.2f,%d,%.0f,%.0f,%s",
                width,
                seed,
                flow,
                flow / width,
                through[frame],
                last * Crowd.STEP_SECONDS,
                frame * Crowd.STEP_SECONDS,
                engine.outcome()));
        return flow;
    }

    private static int through(Agents agents) {
        int count = 0;
        for (int i = 0; i < agents.count; i++) {
            count += agents.x[i] > 22.4 ? 1 : 0;
        }
        return count;
    }
}
