package troupe.cli.command;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import troupe.cli.report.EncounterPictures;
import troupe.cli.report.Pictures;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.run.Run;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.work.GoldenRuns;
import troupe.work.Tasks;

/** Looks at a saved run, or checks it. */
public final class ReplayCommand implements Command {

    @Override
    public String name() {
        return "replay";
    }

    @Override
    public String usage() {
        return "FILE.run [--verify] [--at T --png FILE [--view solid]] [--show KEYS [--ahead S]]"
                + " [--strip FILE] [-o FILE.run] [--json]";
    }

    @Override
    public String summary() {
        return "look at a saved run, or check it";
    }

    @Override
    public List<Option> options() {
        return List.of(
                Option.flag("--verify", "runs the task again and compares every bit; exit code 1 at a difference"),
                Option.of("--at", "T", "the time in seconds that --png shows; without it the end"),
                Option.of("--png", "FILE", "draws a picture, - for standard output"),
                Pictures.VIEW,
                Pictures.TURN,
                EncounterPictures.SHOW,
                EncounterPictures.AHEAD,
                EncounterPictures.STRIP,
                Option.of("-o", "FILE.run", "saves the run, one recovered from a journal too; - for standard output"),
                Option.flag("--json", "prints the report as one JSON object"));
    }

    @Override
    public List<String> notes() {
        return List.of(
                "FILE.run may be FILE.run.journal, which a simulation leaves that was cut off: all frames up to",
                "its last second are there. It is not removed.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal)
            throws UsageException, RunException, ExchangeException, IOException {
        Optional<Double> at = arguments.number("--at");
        if (at.isPresent() && !arguments.has("--png") && !EncounterPictures.areMeant(arguments)) {
            throw new UsageException("--at says what --png shows, and --png is missing");
        }
        if (arguments.has("--view") && !arguments.has("--png")) {
            throw new UsageException("--view says how --png looks, and --png is missing");
        }
        try (InputFile file = InputFile.of(arguments.only("FILE.run"), terminal)) {
            return show(RunFile.read(file.path()), at, arguments, terminal);
        }
    }

    private static int show(Run run, Optional<Double> at, Arguments arguments, Terminal terminal)
            throws UsageException, RunException, ExchangeException, IOException {
        ExportSettings settings = Pictures.seen(ExportSettings.DEFAULT, arguments);
        double time = at.orElse(run.frames().duration());
        if (EncounterPictures.areMeant(arguments)) {
            EncounterPictures.write(run, time, arguments);
        } else if (arguments.has("--png")) {
            Pictures.write(run, time, settings, arguments.needed("--png", "FILE"), terminal);
        }
        Optional<String> target = arguments.value("-o");
        if (target.isPresent() && target.get().equals("-")) {
            RunFile.write(run, terminal.out());
            terminal.out().flush();
            return ExitCode.OK;
        }
        if (target.isPresent()) {
            RunFile.write(run, Arguments.path(target.get()));
        }
        if (arguments.has("--verify")) {
            return verify(run, terminal);
        }
        if (!arguments.value("--png").equals(Optional.of("-"))) {
            terminal.out().println(arguments.has("--json") ? Planning.json(run) : Planning.summary(run));
        }
        return ExitCode.OK;
    }

    private static int verify(Run run, Terminal terminal) throws RunException {
        Run again = Planning.plan(Tasks.again(run), terminal, false);
        Optional<String> difference = GoldenRuns.difference(run, again);
        if (difference.isPresent()) {
            terminal.out().println(run.task() + ": differs: " + difference.get());
            return ExitCode.FAILED;
        }
        terminal.out().println(run.task() + ": verified, " + run.frames().count() + " frames equal bit by bit");
        return ExitCode.OK;
    }
}
