package troupe.cli.command;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.exchange.format.ExchangeException;
import troupe.grid.GridLimitException;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.work.view.Fields;

/** Draws the grid core of a scene. */
public final class FieldsCommand implements Command {

    private static final Option ASPECT =
            Option.many("--aspect", "KEY=N", "which of several sets of views to draw; without it the first");

    @Override
    public String name() {
        return "fields";
    }

    @Override
    public String usage() {
        return "SCENE [--show A,B,C] -o DIR [--aspect KEY=N]... [--width N] [--task ID] [--set KEY=VALUE]...";
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
                ASPECT,
                Option.of("--width", "N", "width of the pictures in pixels; without it 900"),
                Option.of("-o", "DIR", "the folder for the pictures KEY-STOREY.png; made if it is not there"));
    }

    @Override
    public List<String> notes() {
        return List.of(
                "A, B, C: " + String.join(", ", Fields.KEYS) + ".",
                "A picture for each storey; layers that do not lie over each other share one.",
                "What --aspect can choose from is told once the task has been searched: search spaces, instances,",
                "headings. With it the views of the grid are those of the chosen space, too.");
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
            return ExitCode.BAD_INPUT;
        }
        Map<String, Integer> choices = choices(arguments);
        Fields fields;
        try {
            fields = Fields.of(scene, task, keys, choices, terminal.interrupted());
        } catch (Fields.ChoiceException e) {
            throw new UsageException("--aspect " + e.getMessage());
        } catch (GridLimitException tooMuch) {
            terminal.say(tooMuch.getMessage());
            return ExitCode.FAILED;
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
        for (int i = 0; i < fields.aspects().size(); i++) {
            tell(fields.aspects().get(i), fields.chosen().get(i), terminal);
        }
        fields.missing().forEach(terminal::say);
        return ExitCode.OK;
    }

    /** Prints a line for each choice of an aspect, the one that was drawn marked with a star. */
    private static void tell(Aspect aspect, int chosen, Terminal terminal) {
        for (int n = 0; n < aspect.choices().size(); n++) {
            String mark = n == chosen ? "*" : " ";
            String text = aspect.choices().get(n).text();
            terminal.out().println(String.format(Locale.ROOT, "%s %s=%d: %s", mark, aspect.key(), n + 1, text));
        }
    }

    /** Returns the choices after {@code --aspect}, by key. */
    private static Map<String, Integer> choices(Arguments arguments) throws UsageException {
        Map<String, Integer> choices = new TreeMap<>();
        for (String pair : arguments.all("--aspect")) {
            int equals = pair.indexOf('=');
            String number = pair.substring(equals + 1);
            if (equals < 1 || !number.matches("[1-9]\\d{0,8}")) {
                throw new UsageException("--aspect " + pair + "; needs KEY=N with N from 1");
            }
            choices.put(pair.substring(0, equals), Integer.valueOf(number));
        }
        return choices;
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
