package troupe.cli;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import troupe.exchange.ExchangeException;
import troupe.grid.GridLimitException;
import troupe.run.Overlay;
import troupe.scene.Scene;
import troupe.scene.SceneException;
import troupe.scene.SceneSource;
import troupe.work.Fields;

/** Draws the grid core of a scene. */
final class FieldsCommand implements Command {

    @Override
    public String name() {
        return "fields";
    }

    @Override
    public String usage() {
        return "SCENE [--show A,B,C] -o DIR [--width N] [--task ID] [--set KEY=VALUE]...";
    }

    @Override
    public String summary() {
        return "draw the grid core as pictures, and tell the stage times";
    }

    @Override
    public List<Option> options() {
        return List.of(
                SceneFiles.TASK,
                SceneFiles.SET,
                Option.of("--show", "A,B,C", "what to draw; without it everything"),
                Option.of("--width", "N", "width of the pictures in pixels; without it 900"),
                Option.of("-o", "DIR", "the folder for the pictures KEY-STOREY.png; made if it is not there"));
    }

    @Override
    public List<String> notes() {
        return List.of(
                "A, B, C: " + String.join(", ", Fields.KEYS) + ".",
                "A picture for each storey; layers that do not lie over each other share one.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal)
            throws UsageException, SceneException, ExchangeException, IOException {
        String word = arguments.only("SCENE");
        List<String> keys = keys(arguments);
        Path folder = Arguments.path(arguments.needed("-o", "DIR"));
        int width = arguments.whole("--width", 64, 8_192).orElse(900L).intValue();
        SceneSource source = SceneFiles.read(word, terminal);
        String task = SceneFiles.task(source.scene(), arguments, terminal);
        Scene scene = SceneFiles.settled(source.scene(), task, arguments);
        if (SceneFiles.refused(new SceneSource(scene, source.lines()), word, terminal)) {
            return CommandLine.BAD_INPUT;
        }
        Fields fields;
        try {
            fields = Fields.of(scene, task, keys, terminal.interrupted());
        } catch (GridLimitException tooMuch) {
            terminal.say(tooMuch.getMessage());
            return CommandLine.FAILED;
        }
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new FileSystemException(folder.toString(), null, "is a file; -o needs a folder");
        }
        Files.createDirectories(folder);
        for (List<Overlay> shown : fields.overlays()) {
            Overlay first = shown.get(0);
            if (terminal.interrupted().getAsBoolean()) {
                throw new InterruptedIOException("interrupted; the pictures named above are whole");
            }
            Path file = folder.resolve(first.key() + "-" + (first.layer() + 1) + ".png");
            Fields.draw(scene, task, shown, width, file);
            terminal.out().println(file);
        }
        for (Fields.Stage stage : fields.stages()) {
            terminal.out().println(String.format(Locale.ROOT, "%-10s %8.2f ms", stage.name(), stage.millis()));
        }
        fields.missing().forEach(terminal::say);
        return CommandLine.OK;
    }

    /** Returns the keys after {@code --show}; all of them without it. */
    static List<String> keys(Arguments arguments) throws UsageException {
        if (!arguments.has("--show")) {
            return Fields.KEYS;
        }
        List<String> keys = new ArrayList<>();
        for (String key : arguments.needed("--show", "A,B,C").split(",")) {
            if (!Fields.KEYS.contains(key)) {
                throw new UsageException("--show " + key + "; needs one of " + String.join(", ", Fields.KEYS));
            }
            keys.add(key);
        }
        return keys;
    }
}
