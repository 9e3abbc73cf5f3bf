package troupe.cli.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.run.file.RunException;
import troupe.work.GoldenRuns;

/** Records saved runs again after an intended change. */
public final class RecordCommand implements Command {

    @Override
    public String name() {
        return "record";
    }

    @Override
    public String usage() {
        return "DIR";
    }

    @Override
    public String summary() {
        return "record the golden runs of a folder again, and tell what changed";
    }

    @Override
    public List<Option> options() {
        return List.of();
    }

    @Override
    public List<String> notes() {
        return List.of(
                "Every *.run in DIR is planned again from the scene it holds; files that stay equal are left alone.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, RunException, IOException {
        Path folder = Arguments.path(arguments.only("DIR"));
        if (!Files.isDirectory(folder)) {
            throw new UsageException("there is no folder " + folder);
        }
        int all = GoldenRuns.in(folder).size();
        int changed = GoldenRuns.record(folder, terminal.out()::println);
        terminal.out().println(changed + " of " + all + " runs changed");
        return ExitCode.OK;
    }
}
