package troupe.cli.command;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.LongStream;
import troupe.cli.report.Csv;
import troupe.cli.report.ProblemTable;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Output;
import troupe.cli.terminal.ProgressBar;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.MovingAiProblems;
import troupe.run.Engine;
import troupe.run.Report;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.work.batch.Batch;
import troupe.work.batch.ProblemBatch;

/** Plans many cases and writes a table. */
public final class BatchCommand implements Command {
    private static final List<String> COLUMNS =
            List.of("solved", "energy", "cost", "length", "abilities", "moved", "expanded");
    private static final long MAX_SEEDS = 1_000_000;
    private static final int MAX_JOBS = 1_024;

    @Override
    public String name() {
        return "batch";
    }

    @Override
    public String usage() {
        return "SCENE --vary KEY=A,B,C... --seeds 1..N -o FILE.csv | MAP.map --problems MAP.scen -o FILE.csv"
                + " | --encounters 1..N -o FILE.csv | TRACKS.csv --walkers N [--walls FILE.csv] -o FILE.csv";
    }

    @Override
    public String summary() {
        return "plan all combinations of settings, or every problem of a MovingAI scenario, a row each";
    }

    @Override
    public List<Option> options() {
        List<Option> options = new ArrayList<>(List.of(
                SceneFiles.TASK,
                SceneFiles.SET,
                Option.many("--vary", "KEY=A,B,C", "varies a setting; values that hold commas are parted by ;"),
                Option.of("--seeds", "1..N", "the seeds of each combination; without it the scene's own"),
                Option.of("--problems", "MAP.scen", "solves every problem of a scenario file of the map"),
                Option.of("--jobs", "N", "threads; without it one per core, or 1 where the table tells times"),
                Option.of("-o", "FILE.csv", "the table; - for standard output, as without it")));
        options.addAll(EncounterBatches.OPTIONS);
        return options;
    }

    @Override
    public List<String> notes() {
        return List.of(
                "The table of --problems: start,goal,length,optimal,expanded,micros. start and goal are cells \"x y\"",
                "counted as in the file; micros holds both searches of a problem, the one for the cost to go included.",
                "Batches of encounters print their sums by method on standard error: collisions, encounters with one",
                "(struck), arrivals, length divided by the straight one (detour), mean risk, the smallest distance,",
                "and the medians of a step's and of the first plan's time.",
                "Exit code 1: a combination had no solution, or a length is not the file's.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal)
            throws UsageException, SceneException, ExchangeException, IOException {
        if (arguments.has("--problems")) {
            for (String other : List.of("--vary", "--seeds", "--set", "--task")) {
                if (arguments.has(other)) {
                    throw new UsageException(other + " does not go with --problems");
                }
            }
            return problems(arguments, terminal);
        }
        if (EncounterBatches.isMeant(arguments)) {
            for (String other : List.of("--vary", "--seeds", "--task")) {
                if (arguments.has(other)) {
                    throw new UsageException(other + " does not go with --encounters or --walkers");
                }
            }
            return EncounterBatches.run(arguments, terminal);
        }
        return combinations(arguments, terminal);
    }

    private static int jobs(Arguments arguments, int otherwise) throws UsageException {
        return arguments.whole("--jobs", 1, MAX_JOBS).map(Long::intValue).orElse(otherwise);
    }

    private static int combinations(Arguments arguments, Terminal terminal)
            throws UsageException, SceneException, IOException {
        String word = arguments.only("SCENE");
        SceneSource source = SceneFiles.read(word, terminal);
        String task = SceneFiles.task(source.scene(), arguments, terminal);
        Scene scene = SceneFiles.settled(source.scene(), task, arguments);
        if (SceneFiles.refused(new SceneSource(scene, source.lines()), word, terminal)) {
            return ExitCode.BAD_INPUT;
        }
        Batch batch = batch(scene, task, arguments);
        int jobs = jobs(arguments, Runtime.getRuntime().availableProcessors());
        boolean[] solved = {true};
        Output.write(arguments, terminal, out -> {
            out.println(header(batch));
            try (ProgressBar bar = new ProgressBar(terminal.err(), terminal.interactive(), System::nanoTime)) {
                long[] done = {0};
                batch.run(jobs, terminal.interrupted(), row -> {
                    out.println(line(task, row));
                    solved[0] &= row.outcome().isFound();
                    done[0]++;
                    bar.show(new Engine.Progress(done[0], (double) done[0] / batch.size()));
                });
            }
        });
        return solved[0] && !terminal.interrupted().getAsBoolean() ? ExitCode.OK : ExitCode.FAILED;
    }

    private static Batch batch(Scene scene, String task, Arguments arguments) throws UsageException {
        List<Batch.Axis> axes = new ArrayList<>();
        for (String text : arguments.all("--vary")) {
            int equals = text.indexOf('=');
            if (equals < 1) {
                throw new UsageException("--vary " + text + "; needs key=a,b,c");
            }
            axes.add(new Batch.Axis(text.substring(0, equals), values(text.substring(equals + 1))));
        }
        List<Long> seeds = arguments.has("--seeds")
                ? seeds(arguments.needed("--seeds", "1..N"))
                : List.of(scene.task(task).orElseThrow().seed());
        try {
            return new Batch(scene, task, axes, seeds);
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
    }

    /** Parts values by semicolons if there are any, otherwise by the commas outside brackets. */
    static List<String> values(String text) {
        if (text.indexOf(';') >= 0) {
            return List.of(text.split(";", -1));
        }
        List<String> values = new ArrayList<>();
        int depth = 0;
        int begin = 0;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            depth += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (c == ',' && depth == 0) {
                values.add(text.substring(begin, i));
                begin = i + 1;
            }
        }
        values.add(text.substring(begin));
        return values;
    }

    private static List<Long> seeds(String text) throws UsageException {
        int dots = text.indexOf("..");
        try {
            long first = Long.parseLong(dots < 0 ? text : text.substring(0, dots));
            long last = dots < 0 ? first : Long.parseLong(text.substring(dots + 2));
            if (first <= last && last - first >= 0 && last - first < MAX_SEEDS) {
                return LongStream.rangeClosed(first, last).boxed().toList();
            }
        } catch (NumberFormatException e) {
            // told below, like an empty range
        }
        throw new UsageException("--seeds " + text + "; needs 1..N, at most " + MAX_SEEDS + " of them");
    }

    private static String header(Batch batch) {
        List<String> words = new ArrayList<>(List.of("task"));
        batch.axes().forEach(axis -> words.add(axis.key()));
        words.addAll(List.of("seed", "outcome"));
        words.addAll(COLUMNS);
        words.addAll(List.of("frames", "digest", "ms"));
        return Csv.line(words);
    }

    private static String line(String task, Batch.Row row) {
        List<String> words = new ArrayList<>(List.of(task));
        words.addAll(row.of().values());
        words.addAll(List.of(Long.toString(row.of().seed()), row.outcome().word()));
        for (String column : COLUMNS) {
            Object value = row.report().values().get(column);
            words.add(
                    value instanceof List<?> list
                            ? String.join(
                                    " ", list.stream().map(BatchCommand::word).toList())
                            : value == null ? "" : value.toString());
        }
        words.add(Integer.toString(row.frames()));
        words.add(row.digest());
        words.add(String.format(Locale.ROOT, "%.3f", row.millis()));
        return Csv.line(words);
    }

    /** Returns a value of a list as one word: of a report its id. */
    private static String word(Object value) {
        return value instanceof Report report ? String.valueOf(report.values().get("id")) : value.toString();
    }

    private static int problems(Arguments arguments, Terminal terminal)
            throws UsageException, ExchangeException, IOException {
        MovingAiMap map = MovingAiMap.read(Arguments.input(arguments.only("MAP.map")));
        ProblemBatch batch = problemBatch(map, arguments);
        int jobs = jobs(arguments, 1);
        ProblemTable table = new ProblemTable(batch);
        Output.write(arguments, terminal, out -> {
            out.println("start,goal,length,optimal,expanded,micros");
            try (ProgressBar bar = new ProgressBar(terminal.err(), terminal.interactive(), System::nanoTime)) {
                batch.run(jobs, terminal.interrupted(), row -> {
                    out.println(table.line(row));
                    bar.show(new Engine.Progress(table.count(), (double) table.count() / batch.size()));
                });
            }
        });
        table.summary().forEach(terminal::say);
        return table.allEqual() && table.count() == batch.size() ? ExitCode.OK : ExitCode.FAILED;
    }

    private static ProblemBatch problemBatch(MovingAiMap map, Arguments arguments)
            throws UsageException, ExchangeException, IOException {
        try {
            return new ProblemBatch(
                    map, MovingAiProblems.read(Arguments.input(arguments.needed("--problems", "MAP.scen"))));
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
    }
}
