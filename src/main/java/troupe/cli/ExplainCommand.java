package troupe.cli;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CancellationException;
import troupe.run.Run;
import troupe.scene.Scene;
import troupe.scene.SceneException;
import troupe.scene.SceneSource;
import troupe.work.Explainer;
import troupe.work.Explanation;

/** Tells what would change a plan. */
final class ExplainCommand implements Command {

    @Override
    public String name() {
        return "explain";
    }

    @Override
    public String usage() {
        return "SCENE [--task ID] [--set KEY=VALUE]... [--json]";
    }

    @Override
    public String summary() {
        return "tell what would change a plan: other abilities, other preferences";
    }

    @Override
    public List<Option> options() {
        return List.of(SceneFiles.TASK, SceneFiles.SET, Option.flag("--json", "prints one JSON object"));
    }

    @Override
    public List<String> notes() {
        return List.of(
                "Plans again without each ability that the plan uses and, for ordering=optimal, finds the preferences",
                "at which the plan becomes another one, up to 1000 times those of the task. Exit code 1: there is",
                "no plan.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, SceneException, IOException {
        String word = arguments.only("SCENE");
        SceneSource source = SceneFiles.read(word, terminal);
        String task = SceneFiles.task(source.scene(), arguments, terminal);
        Scene scene = SceneFiles.settled(source.scene(), task, arguments);
        if (SceneFiles.refused(new SceneSource(scene, source.lines()), word, terminal)) {
            return CommandLine.BAD_INPUT;
        }
        Run run = Planning.plan(scene, task, terminal, false);
        Explainer explainer = new Explainer((other, id) -> Planning.plan(other, id, terminal, true));
        Explanation explanation;
        try {
            explanation = explainer.explain(run);
        } catch (CancellationException e) {
            terminal.say(e.getMessage());
            return CommandLine.FAILED;
        }
        if (arguments.has("--json")) {
            terminal.out().println(ExplanationText.json(explanation));
        } else {
            ExplanationText.lines(explanation).forEach(terminal.out()::println);
        }
        return run.outcome().isFound() ? CommandLine.OK : CommandLine.FAILED;
    }
}
