package troupe.cli.command;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.risk.TradeOff;
import troupe.run.Json;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Encounter;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.work.explain.Explainer;
import troupe.work.explain.Explanation;

/** Tells what would change a plan. */
public final class ExplainCommand implements Command {
    /** The cautions of an encounter's trade-off, in metres of way for a second of risk 1. */
    private static final List<Double> CAUTIONS = List.of(0.0, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0);

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
                "no plan. Of an encounter it tells what caution costs: length and risk of the optimal plan for several.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, SceneException, IOException {
        String word = arguments.only("SCENE");
        SceneSource source = SceneFiles.read(word, terminal);
        String task = SceneFiles.task(source.scene(), arguments, terminal);
        Scene scene = SceneFiles.settled(source.scene(), task, arguments);
        if (SceneFiles.refused(new SceneSource(scene, source.lines()), word, terminal)) {
            return ExitCode.BAD_INPUT;
        }
        if (scene.task(task).orElseThrow() instanceof Encounter encounter) {
            return tradeOff(scene, encounter, arguments, terminal);
        }
        Run run = Planning.plan(scene, task, terminal, false);
        Explainer explainer = new Explainer((other, id) -> Planning.plan(other, id, terminal, true));
        Explanation explanation;
        try {
            explanation = explainer.explain(run);
        } catch (CancellationException e) {
            terminal.say(e.getMessage());
            return ExitCode.FAILED;
        }
        if (arguments.has("--json")) {
            terminal.out().println(ExplanationText.json(explanation));
        } else {
            ExplanationText.lines(explanation).forEach(terminal.out()::println);
        }
        return run.outcome().isFound() ? ExitCode.OK : ExitCode.FAILED;
    }

    /** Tells what caution costs an encounter: length against risk. */
    private static int tradeOff(Scene scene, Encounter encounter, Arguments arguments, Terminal terminal) {
        List<TradeOff.Choice> choices = TradeOff.of(scene, encounter, CAUTIONS);
        if (arguments.has("--json")) {
            List<Report> rows = choices.stream()
                    .map(c -> Report.builder()
                            .put("caution", c.caution())
                            .put("length", c.length())
                            .put("risk", c.risk())
                            .put("seconds", c.seconds())
                            .build())
                    .toList();
            terminal.out()
                    .println(Json.of(Report.builder()
                            .put("task", encounter.id())
                            .put("trade_off", rows)
                            .build()));
        } else {
            terminal.out().println("caution   length m   risk s   time s");
            choices.forEach(c -> terminal.out()
                    .printf(Locale.ROOT, "%7.2f %10.3f %8.4f %8.2f%n", c.caution(), c.length(), c.risk(), c.seconds()));
        }
        return choices.isEmpty() ? ExitCode.FAILED : ExitCode.OK;
    }
}
