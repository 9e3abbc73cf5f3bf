package troupe.cli.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.file.RunFile;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.work.Tasks;

/** Plans a task of a scene. */
public final class RunCommand implements Command {

    @Override
    public String name() {
        return "run";
    }

    @Override
    public String usage() {
        return "SCENE [--task ID] [--set KEY=VALUE]... [--seed N] [-o FILE.run] [--json] [--quiet]";
    }

    @Override
    public String summary() {
        return "plan or simulate a task of a scene";
    }

    @Override
    public List<Option> options() {
        return List.of(
                SceneFiles.TASK,
                SceneFiles.SET,
                Option.of("--seed", "N", "the seed of every random choice"),
                Option.of("-o", "FILE.run", "writes the run to a file, - for standard output"),
                Option.flag("--json", "prints the report as one JSON object"),
                Option.flag("--quiet", "prints nothing but what was asked for"));
    }

    @Override
    public List<String> notes() {
        return List.of(
                "SCENE is a file, or - for standard input. Exit code 1: there is no solution, or it was not",
                "found within limit.expansions. Ctrl-C ends the work and keeps what is complete. While a",
                "simulation works, FILE.run.journal keeps its frames: troupe replay opens it after a crash.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, SceneException, IOException {
        String word = arguments.only("SCENE");
        SceneSource source = SceneFiles.read(word, terminal);
        String task = SceneFiles.task(source.scene(), arguments, terminal);
        Scene scene = SceneFiles.settled(source.scene(), task, arguments);
        Optional<Long> seed = arguments.whole("--seed", Long.MIN_VALUE, Long.MAX_VALUE);
        if (seed.isPresent()) {
            scene = SceneFiles.set(scene, task, "seed", seed.get().toString());
        }
        if (SceneFiles.refused(new SceneSource(scene, source.lines()), word, terminal)) {
            return ExitCode.BAD_INPUT;
        }
        Optional<String> file = arguments.value("-o");
        boolean piped = file.isPresent() && file.get().equals("-");
        Engine engine = Tasks.start(scene, task);
        Run run;
        if (file.isPresent() && !piped) {
            run = kept(engine, Arguments.path(file.get()), arguments, terminal);
        } else {
            run = Planning.plan(engine, terminal, arguments.has("--quiet"));
        }
        if (piped) {
            RunFile.write(run, terminal.out());
            terminal.out().flush();
        }
        if (arguments.has("--json")) {
            (piped ? terminal.err() : terminal.out()).println(Planning.json(run));
        } else if (!arguments.has("--quiet")) {
            (piped ? terminal.err() : terminal.out()).println(Planning.summary(run));
        }
        return run.outcome().isFound() ? ExitCode.OK : ExitCode.FAILED;
    }

    /** Plans, keeping a journal beside the file until the whole run is in its place. */
    private static Run kept(Engine engine, Path file, Arguments arguments, Terminal terminal) throws IOException {
        try (Journalling journal = new Journalling(file, terminal)) {
            Run run = Planning.plan(engine, terminal, arguments.has("--quiet"), journal);
            RunFile.write(run, file);
            journal.discard();
            return run;
        }
    }
}
