package troupe.cli.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import troupe.cli.report.EncounterTable;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Output;
import troupe.cli.terminal.ProgressBar;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.geometry.Polygon;
import troupe.risk.study.Walkers;
import troupe.run.Engine;
import troupe.scene.Encounter;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.TrackTable;
import troupe.work.batch.EncounterBatch;

/** Runs many encounters, by chance or among recorded people, by several methods side by side. */
final class EncounterBatches {
    private static final String ENCOUNTERS = "--encounters";
    private static final String WALKERS = "--walkers";
    private static final int MAX_CASES = 100_000;

    private EncounterBatches() {}

    /** The options of a batch of encounters. */
    static final List<Option> OPTIONS = List.of(
            Option.of(ENCOUNTERS, "1..N", "random encounters of these seeds, with 1 to 10 avatars"),
            Option.of(WALKERS, "N", "an actor in the place of N walkers of TRACKS.csv, spread evenly over the file"),
            Option.of("--walls", "FILE.csv", "polygon,label,kind,x,y: what stands among the recorded people"),
            Option.of("--methods", "A,B", "of risk, once, static; without it all three, side by side"));

    /** Tells whether a batch is one of encounters. */
    static boolean isMeant(Arguments arguments) {
        return arguments.has(ENCOUNTERS) || arguments.has(WALKERS);
    }

    /** Runs the encounters, writes the table, and prints the sums by method. */
    static int run(Arguments arguments, Terminal terminal) throws UsageException, SceneException, IOException {
        EncounterBatch batch = new EncounterBatch(settled(cases(arguments), arguments), methods(arguments));
        int jobs = arguments.whole("--jobs", 1, 1_024).map(Long::intValue).orElse(1);
        EncounterTable table = new EncounterTable();
        List<String> lines = new ArrayList<>(List.of(EncounterTable.header()));
        try (ProgressBar bar = new ProgressBar(terminal.err(), terminal.interactive(), System::nanoTime)) {
            batch.run(jobs, terminal.interrupted(), row -> {
                lines.add(table.line(row));
                bar.show(new Engine.Progress(lines.size() - 1, (lines.size() - 1.0) / batch.size()));
            });
        }
        Output.write(arguments, terminal, out -> lines.forEach(out::println));
        table.summary().forEach(terminal::say);
        return lines.size() - 1 == batch.size() ? ExitCode.OK : ExitCode.FAILED;
    }

    private static List<EncounterBatch.Case> cases(Arguments arguments)
            throws UsageException, SceneException, IOException {
        if (arguments.has(WALKERS)) {
            String word = arguments.only("TRACKS.csv");
            int most =
                    arguments.whole(WALKERS, 1, MAX_CASES).map(Long::intValue).orElseThrow();
            Optional<String> walls = arguments.value("--walls");
            List<Polygon> polygons = walls.isPresent() ? walls(Arguments.input(walls.get())) : List.of();
            return EncounterBatch.walkers(new Walkers(tracks(Arguments.input(word)), polygons), most);
        }
        if (arguments.count() > 0) {
            throw new UsageException(ENCOUNTERS + " makes its own scenes; leave the file away");
        }
        String word = arguments.needed(ENCOUNTERS, "1..N");
        int dots = word.indexOf("..");
        try {
            long first = Long.parseLong(word.substring(0, Math.max(0, dots)));
            long last = Long.parseLong(word.substring(dots + 2));
            if (first <= last && last - first < MAX_CASES) {
                return EncounterBatch.random(first, last);
            }
        } catch (NumberFormatException e) {
            // told below, like an empty range
        }
        throw new UsageException(ENCOUNTERS + " " + word + "; needs 1..N, at most " + MAX_CASES + " of them");
    }

    /** Reads a table of tracks that tells its own frames per second. */
    static TrackTable tracks(Path file) throws SceneException, IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return TrackTable.read(in, file.toString(), OptionalDouble.empty());
        }
    }

    /** Reads walls, a corner a line: {@code polygon,label,kind,x,y}; remarks begin with {@code #}. */
    private static List<Polygon> walls(Path file) throws SceneException, IOException {
        Map<String, List<double[]>> corners = new LinkedHashMap<>();
        int line = 0;
        for (String text : Files.readAllLines(file)) {
            line++;
            if (text.isBlank() || text.startsWith("#") || text.startsWith("polygon,")) {
                continue;
            }
            String[] words = text.split(",", -1);
            try {
                corners.computeIfAbsent(words[0], key -> new ArrayList<>())
                        .add(new double[] {Double.parseDouble(words[3]), Double.parseDouble(words[4])});
            } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
                throw new SceneException(
                        file.toString(), line, "this is no corner of a wall", "give polygon,label,kind,x,y");
            }
        }
        return corners.values().stream()
                .map(all -> new Polygon(
                        all.stream().mapToDouble(c -> c[0]).toArray(),
                        all.stream().mapToDouble(c -> c[1]).toArray()))
                .toList();
    }

    private static List<EncounterBatch.Case> settled(List<EncounterBatch.Case> cases, Arguments arguments)
            throws UsageException {
        List<EncounterBatch.Case> settled = new ArrayList<>();
        for (EncounterBatch.Case one : cases) {
            Scene scene = SceneFiles.settled(one.scene(), one.task(), arguments);
            settled.add(new EncounterBatch.Case(one.name(), scene, one.task(), one.recorded()));
        }
        return settled;
    }

    private static List<Encounter.Method> methods(Arguments arguments) throws UsageException {
        Optional<String> words = arguments.value("--methods");
        if (words.isEmpty()) {
            return List.of(Encounter.Method.values());
        }
        List<Encounter.Method> methods = new ArrayList<>();
        for (String word : words.get().split(",", -1)) {
            methods.add(Arrays.stream(Encounter.Method.values())
                    .filter(m -> m.name().toLowerCase(Locale.ROOT).equals(word.strip()))
                    .findFirst()
                    .orElseThrow(() -> new UsageException("--methods " + word + "; known are risk, once, static")));
        }
        return methods;
    }
}
