package troupe.cli.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Output;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.Importer;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;
import troupe.work.inspect.SceneInspection;

/** Makes a scene of another program's file. */
public final class ImportCommand implements Command {

    @Override
    public String name() {
        return "import";
    }

    @Override
    public String usage() {
        return "FILE -o SCENE.xml [--format F]";
    }

    @Override
    public String summary() {
        return "make a scene of another program's file";
    }

    @Override
    public List<Option> options() {
        return List.of(
                Option.of("--format", "F", "the format, see below; without it the one that FILE's ending names"),
                Option.of("-o", "SCENE.xml", "the scene, - for standard output"));
    }

    @Override
    public List<String> notes() {
        List<String> lines = new ArrayList<>();
        for (Importer importer : Formats.importers()) {
            lines.add(importer.name() + ": " + importer.about());
        }
        return lines;
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, ExchangeException, IOException {
        String target = arguments.needed("-o", "SCENE.xml");
        Scene scene;
        try (InputFile file = InputFile.of(arguments.only("FILE"), terminal)) {
            scene = importer(arguments, file.path()).read(file.path());
        }
        Output.write(arguments, terminal, out -> out.print(SceneXml.write(scene)));
        if (scene.tasks().isEmpty()) {
            terminal.say("the scene has no task yet; " + SceneInspection.addTask(scene)
                    + (target.equals("-") ? "" : ", then: troupe run " + target));
        }
        return ExitCode.OK;
    }

    private static Importer importer(Arguments arguments, Path file) throws UsageException {
        Optional<String> format = arguments.value("--format");
        try {
            if (format.isPresent()) {
                return Formats.importer(format.get());
            }
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
        return Formats.importerFor(file)
                .orElseThrow(() -> new UsageException("needs --format; there are "
                        + String.join(
                                ", ",
                                Formats.importers().stream().map(Importer::name).toList())));
    }
}
