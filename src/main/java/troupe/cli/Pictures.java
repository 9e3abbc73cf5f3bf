package troupe.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import troupe.exchange.ExchangeException;
import troupe.exchange.ExportSettings;
import troupe.exchange.Exporter;
import troupe.exchange.Formats;
import troupe.run.Run;

/** Sends what an exporter writes to a file or to standard output. */
final class Pictures {
    private Pictures() {}

    /** Draws a run at a time in seconds. */
    static void write(Run run, double time, String target, Terminal terminal)
            throws UsageException, ExchangeException, IOException {
        ExportSettings settings;
        try {
            settings = ExportSettings.DEFAULT.at(time);
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
        export(Formats.exporter("png"), run, settings, target, terminal);
    }

    /** Writes a run in a format; for {@code -} by way of a temporary file, so that nothing half-made is sent. */
    static void export(Exporter exporter, Run run, ExportSettings settings, String target, Terminal terminal)
            throws UsageException, ExchangeException, IOException {
        if (!target.equals("-")) {
            exporter.write(run, settings, Arguments.path(target));
            return;
        }
        Path folder = Files.createTempDirectory("troupe");
        try {
            exporter.write(run, settings, folder.resolve("run." + exporter.extension()));
            List<Path> files;
            try (Stream<Path> all = Files.list(folder)) {
                files = all.toList();
            }
            if (files.size() != 1) {
                throw new UsageException("format " + exporter.name() + " makes " + files.size()
                        + " files; standard output takes one: give -o a name");
            }
            Files.copy(files.get(0), terminal.out());
            terminal.out().flush();
        } finally {
            delete(folder);
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            for (Path file : all.toList()) {
                Files.delete(file);
            }
        }
        Files.delete(folder);
    }
}
