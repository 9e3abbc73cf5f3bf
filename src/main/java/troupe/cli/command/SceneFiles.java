package troupe.cli.command;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.check.Severity;
import troupe.scene.setting.Settings;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;
import troupe.work.inspect.SceneInspection;

/** Reads scenes for commands and applies what the command line sets. */
final class SceneFiles {
    static final Option TASK = Option.of("--task", "ID", "the task; without it the first one of the scene");
    static final Option SET =
            Option.many("--set", "KEY=VALUE", "changes a setting: ordering=paper, preference.vault=2, start=2.9,0.9");

    private SceneFiles() {}

    /** Reads a scene from a file, or from standard input for {@code -}. */
    static SceneSource read(String word, Terminal terminal) throws UsageException, SceneException, IOException {
        return word.equals("-") ? SceneXml.read(terminal.in(), "standard input") : SceneXml.read(Arguments.input(word));
    }

    /** Tells every error of a scene and returns whether there was one. */
    static boolean refused(SceneSource source, String word, Terminal terminal) {
        List<Problem> errors = SceneChecks.check(source.scene(), source.lines()).stream()
                .filter(p -> p.severity() == Severity.ERROR)
                .toList();
        errors.forEach(p -> terminal.say(word + line(p)));
        return !errors.isEmpty();
    }

    /** Returns a problem as one line. */
    static String line(Problem problem) {
        return (problem.line() > 0 ? ":" + problem.line() : "") + ": "
                + problem.severity().name().toLowerCase(java.util.Locale.ROOT) + ": "
                + (problem.element().isEmpty() ? "" : problem.element() + ": ") + problem.message()
                + (problem.cure().isEmpty() ? "" : "; " + problem.cure());
    }

    /** Returns the id of the task that is meant. */
    static String task(Scene scene, Arguments arguments, Terminal terminal) throws UsageException, SceneException {
        if (scene.tasks().isEmpty()) {
            throw new SceneException(
                    arguments.only("SCENE"), 0, "the scene has no task to plan", SceneInspection.addTask(scene));
        }
        String first = scene.tasks().get(0).id();
        String id = arguments.value(TASK.name()).orElse(first);
        if (scene.task(id).isEmpty()) {
            throw new UsageException("unknown task '" + id + "'; the scene has " + Tasks.ids(scene));
        }
        if (!arguments.has(TASK.name()) && scene.tasks().size() > 1 && !arguments.has("--quiet")) {
            terminal.say("task '" + id + "' of " + Tasks.ids(scene));
        }
        return id;
    }

    /** Returns the scene with every {@code --set key=value} applied, in order. */
    static Scene settled(Scene scene, String task, Arguments arguments) throws UsageException {
        Scene changed = scene;
        for (String setting : arguments.all(SET.name())) {
            int equals = setting.indexOf('=');
            if (equals < 1) {
                throw new UsageException("--set " + setting + "; needs key=value");
            }
            changed = set(changed, task, setting.substring(0, equals), setting.substring(equals + 1));
        }
        if (changed != scene) {
            refuse(scene, changed, task, arguments);
        }
        return changed;
    }

    /** Refuses settings that make an error of a scene: the file is not to blame for it. */
    private static void refuse(Scene scene, Scene changed, String task, Arguments arguments) throws UsageException {
        List<String> before = errors(scene);
        List<String> errors = new ArrayList<>(errors(changed));
        errors.removeAll(before);
        if (errors.isEmpty()) {
            return;
        }
        Scene partly = scene;
        for (String setting : arguments.all(SET.name())) {
            int equals = setting.indexOf('=');
            partly = set(partly, task, setting.substring(0, equals), setting.substring(equals + 1));
            if (errors(partly).contains(errors.get(0))) {
                throw new UsageException("--set " + setting + ": " + errors.get(0));
            }
        }
        throw new UsageException("--set: " + errors.get(0));
    }

    private static List<String> errors(Scene scene) {
        return SceneChecks.check(scene).stream()
                .filter(p -> p.severity() == Severity.ERROR)
                .map(p -> line(p).replaceFirst("^: error: ", ""))
                .toList();
    }

    /** Returns the scene with one setting changed. */
    static Scene set(Scene scene, String task, String key, String value) throws UsageException {
        try {
            return Settings.apply(scene, task, key, value);
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
    }
}
