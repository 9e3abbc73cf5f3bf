package troupe.cli.command;

import java.io.IOException;
import java.util.List;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.work.inspect.SceneInspection;

/** Tells every problem of a scene. */
public final class CheckCommand implements Command {

    @Override
    public String name() {
        return "check";
    }

    @Override
    public String usage() {
        return "SCENE";
    }

    @Override
    public String summary() {
        return "tell every problem of a scene; exit code 1 if one is an error";
    }

    @Override
    public List<Option> options() {
        return List.of();
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, SceneException, IOException {
        String word = arguments.only("SCENE");
        SceneSource source;
        try {
            source = SceneFiles.read(word, terminal);
        } catch (SceneException e) {
            e.problems().forEach(p -> terminal.say(word + SceneFiles.line(p)));
            return ExitCode.BAD_INPUT;
        }
        List<Problem> problems = SceneInspection.check(source);
        problems.forEach(p -> terminal.out().println(word + SceneFiles.line(p)));
        long errors =
                problems.stream().filter(p -> p.severity() == Severity.ERROR).count();
        terminal.out()
                .println(word + ": " + count(errors, "error") + ", " + count(problems.size() - errors, "warning"));
        return errors > 0 ? ExitCode.FAILED : ExitCode.OK;
    }

    private static String count(long n, String word) {
        return n + " " + word + (n == 1 ? "" : "s");
    }
}
