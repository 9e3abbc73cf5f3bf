package troupe.cli.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.paint.solid.Camera;
import troupe.run.Run;

/** Sends what an exporter writes to a file or to standard output. */
public final class Pictures {
    /** Chooses between the plan and the view in three dimensions. */
    public static final Option VIEW = Option.of("--view", "V", "plan or solid: from above, or in three dimensions");

    /** Says from where the view in three dimensions is seen. */
    public static final Option TURN =
            Option.of("--turn", "A,E", "azimuth and elevation of the eye in degrees; without it 32,38");

    private Pictures() {}

    /** Returns settings for the view that the arguments choose. */
    public static ExportSettings seen(ExportSettings settings, Arguments arguments) throws UsageException {
        String view = arguments.value("--view").orElse("plan");
        Optional<String> turn = arguments.value("--turn");
        if (view.equals("plan") && turn.isEmpty()) {
            return settings;
        }
        if (!view.equals("solid")) {
            throw new UsageException(
                    turn.isPresent() && view.equals("plan")
                            ? "--turn needs --view solid"
                            : "--view " + view + "; needs plan or solid");
        }
        return settings.from(turn.isPresent() ? angle(turn.get()) : Camera.Angle.DEFAULT);
    }

    private static Camera.Angle angle(String turn) throws UsageException {
        String[] parts = turn.split(",", -1);
        try {
            if (parts.length == 2) {
                return new Camera.Angle(
                        Math.toRadians(Double.parseDouble(parts[0])), Math.toRadians(Double.parseDouble(parts[1])));
            }
        } catch (IllegalArgumentException e) {
            throw new UsageException("--turn " + turn + "; needs azimuth,elevation in degrees, elevation 10 to 85", e);
        }
        throw new UsageException("--turn " + turn + "; needs azimuth,elevation in degrees, elevation 10 to 85");
    }

    /** Draws a run at a time in seconds. */
    public static void write(Run run, double time, ExportSettings view, String target, Terminal terminal)
            throws UsageException, ExchangeException, IOException {
        ExportSettings settings;
        try {
            settings = view.at(time);
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
        export(Formats.exporter("png"), run, settings, target, terminal);
    }

    /** Writes a run in a format; for {@code -} by way of a temporary file, so that nothing half-made is sent. */
    public static void export(Exporter exporter, Run run, ExportSettings settings, String target, Terminal terminal)
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
