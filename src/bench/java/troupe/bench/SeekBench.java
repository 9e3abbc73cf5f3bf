package troupe.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import troupe.geometry.Polygon;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.run.frame.Channel;
import troupe.run.frame.Channel.Type;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

/**
 * Measures how long any frame of a saved run takes: 1,000 agents over ten minutes, which stay in the file. Reads
 * every value of frames at random places, each in another second than the one before; aim: below 16 ms. Argument: a file in which the run is kept.
 */
public final class SeekBench {
    private static final int AGENTS = 1_000;
    private static final int FRAMES = 10 * 60 * 25;
    private static final int SEEKS = 300;

    private SeekBench() {}

    /** Walks in circles, computed when asked for, so that only the file holds the run. */
    private record Circles(List<Channel> channels) implements Frames {
        @Override
        public double rate() {
            return 25;
        }

        @Override
        public int count() {
            return FRAMES;
        }

        @Override
        public double value(int frame, int channel, int k) {
            double angle = 0.01 * frame + k;
            return switch (channel) {
                case 0 -> 50 + 40 * Math.cos(angle) + 0.01 * k;
                case 1 -> 50 + 40 * Math.sin(angle);
                case 3 -> angle % Math.PI;
                default -> 0;
            };
        }
    }

    /** Writes, opens and seeks. */
    public static void main(String[] arguments) throws IOException, RunException {
        CrowdGroup.Members members =
                new CrowdGroup.Members(AGENTS, Polygon.rectangle(1, 1, 99, 99), OptionalDouble.empty(), 0.2, 1.3);
        Crowd crowd = Crowd.of("go", List.of(CrowdGroup.of("all", Place.of(50, 50), members)));
        Scene scene = new Scene("", new World(100, 100, 0.2), List.of(), List.of(), List.of(), List.of(crowd));
        List<Channel> channels = List.of(
                new Channel("x", "m", Type.F64, "all", AGENTS),
                new Channel("y", "m", Type.F64, "all", AGENTS),
                new Channel("z", "m", Type.F32, "all", AGENTS),
                new Channel("heading", "rad", Type.F32, "all", AGENTS),
                new Channel("state", "walking,waiting,arrived", Type.U8, "all", AGENTS));
        Report none = Report.builder().build();
        Run run = new Run(scene, "go", Outcome.FOUND, none, new Circles(channels), List.of(), List.of());
        Path file = arguments.length > 0 ? Path.of(arguments[0]) : Files.createTempFile("seek", ".run");
        try {
            long begin = System.nanoTime();
            RunFile.write(run, file);
            long written = System.nanoTime();
            Frames frames = RunFile.read(file).frames();
            long read = System.nanoTime();
            System.out.printf(
                    "%,d bytes; written in %.1f s, opened and checked whole in %.1f s%n",
                    Files.size(file), (written - begin) / 1e9, (read - written) / 1e9);
            seek(frames);
        } finally {
            if (arguments.length == 0) {
                Files.delete(file);
            }
        }
    }

    private static void seek(Frames frames) {
        SplittableRandom random = new SplittableRandom(1);
        double[] wall = new double[SEEKS];
        double[] cpu = new double[SEEKS];
        double sum = 0;
        var threads = ManagementFactory.getThreadMXBean();
        for (int k = -20; k < SEEKS; k++) {
            int frame = random.nextInt(FRAMES);
            long begin = System.nanoTime();
            long beginCpu = threads.getCurrentThreadCpuTime();
            for (int channel = 0; channel < 5; channel++) {
                for (int agent = 0; agent < AGENTS; agent++) {
                    sum += frames.value(frame, channel, agent);
                }
            }
            if (k >= 0) {
                cpu[k] = (threads.getCurrentThreadCpuTime() - beginCpu) / 1e6;
                wall[k] = (System.nanoTime() - begin) / 1e6;
            }
        }
        print("processor", cpu);
        print("wall", wall);
        System.out.println("sum " + sum);
    }

    private static void print(String what, double[] millis) {
        Arrays.sort(millis);
        System.out.printf(
                "a frame anywhere, %s time: median %.2f ms, 99 of 100 %.2f ms, most %.2f ms%n",
                what, millis[SEEKS / 2], millis[SEEKS * 99 / 100], millis[SEEKS - 1]);
    }
}
