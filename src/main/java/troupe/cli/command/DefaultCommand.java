package troupe.cli.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
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
import troupe.run.file.RunFile;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.work.Window;

/** Opens the studio, or plans the default scene where there is no display. */
public final class DefaultCommand implements Command {
    private static final String SCENE = "scenes/unified/courtyard.xml";

    private final Supplier<Optional<Window>> window;

    /** Makes the command; {@code window} gives the window, if there is a display for it. */
    public DefaultCommand(Supplier<Optional<Window>> window) {
        this.window = window;
    }

    @Override
    public String name() {
        return "";
    }

    @Override
    public String usage() {
        return "";
    }

    @Override
    public String summary() {
        return "open the studio";
    }

    @Override
    public List<Option> options() {
        return List.of();
    }

    @Override
    public int run(Arguments arguments, Terminal terminal)
            throws UsageException, SceneException, ExchangeException, IOException {
        Optional<Window> found = window.get();
        if (found.isPresent()) {
            found.get().open(Optional.empty());
            return ExitCode.OK;
        }
        terminal.say("there is no display for the studio; planning " + SCENE + " instead");
        Scene scene = scene(terminal.folder());
        Run run = Planning.plan(scene, scene.tasks().get(0).id(), terminal, false);
        Path target = terminal.folder().resolve("target");
        Path folder = Files.isDirectory(target) ? target : terminal.folder();
        Path file = folder.resolve("courtyard.run");
        Path picture = folder.resolve("courtyard.png");
        RunFile.write(run, file);
        Pictures.write(run, run.frames().duration(), ExportSettings.DEFAULT, picture.toString(), terminal);
        terminal.out().println(Planning.summary(run));
        terminal.out().println("picture: " + picture.toAbsolutePath());
        terminal.out().println("run:     " + file.toAbsolutePath());
        return run.outcome().isFound() ? ExitCode.OK : ExitCode.FAILED;
    }

    private static Scene scene(Path folder) throws SceneException, IOException {
        Path file = folder.resolve(SCENE);
        if (Files.exists(file)) {
            return SceneXml.read(file).scene();
        }
        try (InputStream in = DefaultCommand.class.getResourceAsStream("/" + SCENE)) {
            if (in == null) {
                throw new IOException("the program lacks its default scene " + SCENE);
            }
            return SceneXml.read(in, SCENE).scene();
        }
    }
}
