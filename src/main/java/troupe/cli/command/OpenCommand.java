package troupe.cli.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.scene.xml.SceneException;
import troupe.work.Window;

/** Opens the studio. */
public final class OpenCommand implements Command {

    @Override
    public String name() {
        return "open";
    }

    @Override
    public String usage() {
        return "[FILE]";
    }

    @Override
    public String summary() {
        return "open the studio, with a scene if one is named";
    }

    @Override
    public List<Option> options() {
        return List.of();
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, SceneException, IOException {
        Optional<Path> file =
                arguments.count() == 0 ? Optional.empty() : Optional.of(Arguments.input(arguments.only("FILE")));
        if (file.isPresent() && !Files.exists(file.get())) {
            throw new NoSuchFileException(file.get().toString());
        }
        Optional<Window> window = window();
        if (window.isEmpty()) {
            throw new UsageException("there is no display to open the studio on; troupe run plans without one");
        }
        window.get().open(file);
        return ExitCode.OK;
    }

    /** Finds the window, if there is a display for it. */
    public static Optional<Window> window() {
        return ServiceLoader.load(Window.class).findFirst().filter(Window::available);
    }
}
