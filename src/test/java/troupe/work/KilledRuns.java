package troupe.work;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import troupe.geometry.Polygon;
import troupe.run.Run;
import troupe.run.RunComparison;
import troupe.run.Simulation;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.run.file.RunJournal;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Runs a crowd with a journal in another process and kills that (SIGKILL) at random moments. Its {@link #main} is
 * that other process.
 */
public final class KilledRuns {
    private KilledRuns() {}

    private static Scene scene() {
        return scene(40, 1200);
    }

    /** Returns a crowd that has nowhere near enough time to arrive. */
    public static Scene scene(int people, double seconds) {
        double side = people / 5.0;
        Polygon spawn = Polygon.rectangle(1, 1, 1 + side, 9);
        CrowdGroup.Members members = new CrowdGroup.Members(people, spawn, OptionalDouble.empty(), 0.2, 0.02);
        CrowdGroup group = CrowdGroup.of("all", Place.of(30 + side, 5), members);
        Crowd crowd = Crowd.of("go", List.of(group)).lasting(seconds);
        return new Scene("", new World(32 + side, 10, 0.2), List.of(), List.of(), List.of(), List.of(crowd));
    }

    /** Simulates without end; after each slice that was kept it prints the number of frames kept. */
    public static void main(String[] arguments) throws IOException {
        try (RunJournal journal = new RunJournal(Path.of(arguments[0]))) {
            Simulation simulation = (Simulation) Tasks.start(scene(), "go");
            int told = -1;
            while (simulation.step(3).isRunning()) {
                journal.keep(simulation);
                if (journal.frames() != told) {
                    told = journal.frames();
                    System.out.println(told);
                }
            }
        }
    }

    /**
     * Kills a child at a random moment: after some number of lines of it, and a wait of up to {@code mostMillis}.
     *
     * @return what was found: frames recovered, frames that the child had said to be kept, lost bytes
     * @throws IllegalStateException if less than what was said is there, or other frames
     */
    public static long[] kill(Path folder, SplittableRandom random, int mostMillis)
            throws IOException, RunException, InterruptedException {
        Path target = folder.resolve("killed.run");
        Process child = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-Xshare:auto",
                        "-cp",
                        System.getProperty("java.class.path"),
                        KilledRuns.class.getName(),
                        target.toString())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        long said = 0;
        try (BufferedReader out =
                new BufferedReader(new InputStreamReader(child.getInputStream(), StandardCharsets.UTF_8))) {
            for (int k = 1 + random.nextInt(20); k > 0; k--) {
                said = Long.parseLong(out.readLine());
            }
            child.waitFor(random.nextInt(1 + mostMillis), TimeUnit.MILLISECONDS);
            // by its handle, which leaves what it has said to be read
            child.toHandle().destroyForcibly();
            child.waitFor();
            // a line may be cut off by the kill; one that is whole ends in a line end
            StringBuilder rest = new StringBuilder();
            for (int c = read(out); c >= 0; c = read(out)) {
                rest.append((char) c);
            }
            for (String line :
                    rest.substring(0, rest.lastIndexOf("\n") + 1).lines().toList()) {
                said = Long.parseLong(line);
            }
        } finally {
            child.destroyForcibly();
        }
        Path journal = folder.resolve("killed.run.journal");
        Run run = RunFile.read(journal);
        check(run, said);
        Files.delete(journal);
        return new long[] {
            run.frames().count(), said, (Long) run.report().values().get("lost_bytes")
        };
    }

    private static int read(BufferedReader out) {
        try {
            return out.read();
        } catch (IOException e) {
            // the stream of a process that was killed may end in any way
            return -1;
        }
    }

    private static void check(Run run, long said) {
        int count = run.frames().count();
        if (!RunJournal.recovered(run) || count < said) {
            throw new IllegalStateException(count + " frames recovered of " + said + " that were kept");
        }
        Simulation again = (Simulation) Tasks.start(scene(), "go");
        again.step(count);
        Optional<String> difference = RunComparison.firstDifference(again.run().frames(), run.frames(), count);
        if (difference.isPresent()) {
            throw new IllegalStateException(difference.get());
        }
    }
}
