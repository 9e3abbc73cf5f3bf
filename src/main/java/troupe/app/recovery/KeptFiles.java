package troupe.app.recovery;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Names the files in which unsaved edits are kept, and finds those that a process left behind which is gone:
 * {@code .NAME.PROCESS.troupe} beside the file {@code NAME}, or {@code .PROCESS.troupe} in a folder of the person's
 * for a document without a file; {@code .PROCESS.run.journal} there for what is simulated. Its methods run on any thread but the event thread.
 *
 * @param folder where documents without a file are kept
 */
public record KeptFiles(Path folder) {
    private static final String ENDING = ".troupe";
    private static final String JOURNAL = ".journal";
    private static final Pattern RUN = Pattern.compile("\\.([0-9]+)\\.run(?:\\.[0-9]+)?\\.journal");
    private static final Pattern NAME = Pattern.compile("\\.(?:(.+)\\.)?([0-9]+)\\.troupe");

    /**
     * Edits that were left behind.
     *
     * @param file the document they belong to, empty for one that was never saved
     * @param kept where they are kept
     * @param time when they were kept
     */
    public record Left(Optional<Path> file, Path kept, Instant time) {}

    /** Returns where this process keeps the edits of a document. */
    public Path slot(Optional<Path> document) {
        String mine = ProcessHandle.current().pid() + ENDING;
        return document.map(file -> file.resolveSibling("." + file.getFileName() + "." + mine))
                .orElse(folder.resolve("." + mine));
    }

    /**
     * Returns what was left behind of these documents, the newest first.
     *
     * @throws IOException if a folder that is there cannot be listed
     */
    public List<Left> leftOf(Collection<Path> documents) throws IOException {
        List<Left> found = new ArrayList<>();
        Set<Path> folders = new LinkedHashSet<>();
        Set<Path> wanted = new LinkedHashSet<>();
        for (Path document : documents) {
            Path whole = document.toAbsolutePath().normalize();
            wanted.add(whole);
            folders.add(whole.getParent());
        }
        for (Path in : folders) {
            for (Left left : list(in)) {
                if (left.file().filter(wanted::contains).isPresent()) {
                    found.add(left);
                }
            }
        }
        return sorted(found);
    }

    /**
     * Returns what was left behind of documents without a file, the newest first.
     *
     * @throws IOException if the folder is there and cannot be listed
     */
    public List<Left> leftUnnamed() throws IOException {
        return sorted(
                list(folder).stream().filter(left -> left.file().isEmpty()).toList());
    }

    /** Returns the run beside which this process keeps the journal of what it simulates. */
    public Path run() {
        return folder.resolve("." + ProcessHandle.current().pid() + ".run");
    }

    /**
     * Returns the journals of simulations that were left behind, the newest first.
     *
     * @throws IOException if the folder is there and cannot be listed
     */
    public List<Left> leftRuns() throws IOException {
        List<Left> found = new ArrayList<>();
        for (Path file : files(folder, JOURNAL)) {
            Matcher parts = RUN.matcher(file.getFileName().toString());
            Instant time = parts.matches() ? Files.getLastModifiedTime(file).toInstant() : Instant.EPOCH;
            if (parts.matches() && !belongsToSomebody(parts.group(1), time)) {
                found.add(new Left(Optional.empty(), file, time));
            }
        }
        return sorted(found);
    }

    private static List<Path> files(Path in, String ending) throws IOException {
        if (in == null || !Files.isDirectory(in)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(in)) {
            return all.filter(f -> f.getFileName().toString().endsWith(ending) && Files.isRegularFile(f))
                    .toList();
        }
    }

    private static List<Left> sorted(List<Left> found) {
        return found.stream()
                .sorted(Comparator.comparing(Left::time).reversed().thenComparing(left -> left.kept()
                        .toString()))
                .toList();
    }

    private static List<Left> list(Path in) throws IOException {
        List<Left> found = new ArrayList<>();
        for (Path file : files(in, ENDING)) {
            Matcher parts = NAME.matcher(file.getFileName().toString());
            if (parts.matches()) {
                Instant time = Files.getLastModifiedTime(file).toInstant();
                if (!belongsToSomebody(parts.group(2), time)) {
                    found.add(new Left(Optional.ofNullable(parts.group(1)).map(in::resolve), file, time));
                }
            }
        }
        return found;
    }

    /** Tells whether the process with this number runs, and did so already when the file was written. */
    private static boolean belongsToSomebody(String number, Instant written) {
        try {
            return ProcessHandle.of(Long.parseLong(number))
                    .filter(ProcessHandle::isAlive)
                    .filter(process -> process.info()
                            .startInstant()
                            .map(start -> !start.isAfter(written.plusSeconds(1)))
                            .orElse(true))
                    .isPresent();
        } catch (NumberFormatException e) {
            // longer than any number of a process
            return false;
        }
    }
}
