package troupe.work;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import troupe.run.Run;
import troupe.run.RunComparison;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.search.Outcome;

/** Runs saved runs again and compares, bit by bit: regression tests that a person can watch. */
public final class GoldenRuns {
    private GoldenRuns() {}

    /** Returns the run files of a folder, sorted by name. */
    public static List<Path> in(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(f -> f.getFileName().toString().endsWith(".run"))
                    .sorted()
                    .toList();
        }
    }

    /**
     * Runs the task of a saved run again, from what the run holds, to its end.
     *
     * @throws RunException if the run's inputs do not fit its task
     */
    public static Run again(Run saved) throws RunException {
        return Tasks.again(saved).finish();
    }

    /**
     * Names the first difference between a saved run and another of the same task; nothing if they are
     * equal. Of a saved run that had not ended, or was cancelled, only the frames that are there are compared.
     */
    public static Optional<String> difference(Run saved, Run fresh) {
        boolean cut = saved.outcome().isRunning() || saved.outcome().equals(Outcome.CANCELLED);
        if (cut) {
            int kept = saved.frames().count();
            return fresh.frames().count() < kept
                    ? Optional.of("frames: expected at least " + kept + ", found "
                            + fresh.frames().count())
                    : RunComparison.firstDifference(saved.frames(), fresh.frames(), kept);
        }
        if (!saved.outcome().equals(fresh.outcome())) {
            return Optional.of("outcome: expected " + words(saved.outcome()) + ", found " + words(fresh.outcome()));
        }
        return RunComparison.firstDifference(saved.frames(), fresh.frames());
    }

    private static String words(Outcome outcome) {
        return outcome instanceof Outcome.Infeasible none
                ? outcome.word() + " (" + none.reason() + ")"
                : outcome.word();
    }

    /**
     * Records every run of a folder again. A file is written only if its frames, outcome or report changed;
     * {@code tell} gets a line for each run and for each value that changed.
     *
     * @return how many files changed
     * @throws RunException if a file cannot be read; those before it are recorded
     */
    public static int record(Path folder, Consumer<String> tell) throws IOException, RunException {
        int changed = 0;
        for (Path file : in(folder)) {
            Run saved = RunFile.read(file);
            Run fresh = again(saved);
            Optional<String> difference = difference(saved, fresh);
            List<String> report = RunComparison.differences(saved.report(), fresh.report());
            if (difference.isEmpty() && report.isEmpty()) {
                tell.accept(file.getFileName() + ": unchanged");
                continue;
            }
            changed++;
            tell.accept(file.getFileName() + ": changed, " + difference.orElse("frames equal"));
            report.forEach(line -> tell.accept("  " + line));
            RunFile.write(fresh, file);
        }
        return changed;
    }
}
