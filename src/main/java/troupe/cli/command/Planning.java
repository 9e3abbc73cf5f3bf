package troupe.cli.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import troupe.cli.terminal.ProgressBar;
import troupe.cli.terminal.Terminal;
import troupe.run.Digest;
import troupe.run.Engine;
import troupe.run.Json;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.run.file.RunJournal;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.work.Tasks;

/** Plans a task under a progress bar, and says what came of it. */
final class Planning {
    private static final long SLICE = 5_000;
    private static final long STEPS = 5;
    private static final List<String> STABLE_KEYS =
            List.of("solved", "energy", "cost", "length", "abilities", "moved", "expanded", "times_ms");

    private Planning() {}

    /** Plans a task to its end, or until the person interrupts. */
    static Run plan(Scene scene, String task, Terminal terminal, boolean quiet) {
        return plan(Tasks.start(scene, task), terminal, quiet);
    }

    /** Works until an engine has ended, or the person interrupts. */
    static Run plan(Engine engine, Terminal terminal, boolean quiet) {
        return plan(engine, terminal, quiet, worked -> {});
    }

    /** Works until an engine has ended, or the person interrupts, and tells {@code after} about each slice of work. */
    static Run plan(Engine engine, Terminal terminal, boolean quiet, Consumer<Engine> after) {
        long slice = engine instanceof Simulation ? STEPS : SLICE;
        try (ProgressBar bar = new ProgressBar(terminal.err(), terminal.interactive() && !quiet, System::nanoTime)) {
            while (engine.step(slice).isRunning()) {
                bar.show(engine.progress());
                after.accept(engine);
                if (terminal.interrupted().getAsBoolean()) {
                    engine.cancel();
                }
            }
        }
        return engine.run();
    }

    /** Returns the object that {@code --json} prints: the stable keys first, then the planner's own. */
    static String json(Run run) {
        Map<String, Object> values = run.report().values();
        Report.Builder object = Report.builder().put("task", run.task());
        for (String key : STABLE_KEYS) {
            if (values.containsKey(key)) {
                object.put(key, values.get(key));
            }
        }
        object.put("frames", run.frames().count()).put("digest", Digest.of(run.frames()));
        object.put("outcome", run.outcome().word());
        if (run.outcome() instanceof Outcome.Infeasible infeasible) {
            object.put("reason", infeasible.reason());
        }
        Report head = object.build();
        Report.Builder whole = Report.builder();
        head.values().forEach(whole::put);
        values.forEach((key, value) -> {
            if (!head.values().containsKey(key)) {
                whole.put(key, value);
            }
        });
        return Json.of(whole.build());
    }

    /** Returns what came of a run in a few words. */
    static String summary(Run run) {
        if (RunJournal.recovered(run)) {
            return String.format(
                    Locale.ROOT,
                    "%s: recovered, %,d of ? frames, %.2f s",
                    run.task(),
                    run.frames().count(),
                    run.frames().duration());
        }
        if (run.outcome() instanceof Outcome.Infeasible infeasible) {
            return run.task() + ": no solution: " + infeasible.reason();
        }
        if (run.outcome() instanceof Outcome.Exhausted && run.report().values().containsKey("arrived")) {
            return run.task() + ": time is over; " + arrivals(run);
        }
        if (run.outcome() instanceof Outcome.Exhausted && run.report().values().containsKey("arrival")) {
            return run.task() + ": gave up at the limit of time (duration); " + meetings(run);
        }
        if (run.outcome() instanceof Outcome.Exhausted
                && "limit.spaces".equals(run.report().values().get("limit"))) {
            return run.task()
                    + ": gave up at the limit of search spaces (limit.spaces), ways of moving several obstacles; there may"
                    + " still be a solution: make fewer of them movable, or allow more with more memory (-Xmx)";
        }
        if (run.outcome() instanceof Outcome.Exhausted) {
            return run.task()
                    + ": gave up at the limit of expansions (limit.expansions); there may still be a solution";
        }
        if (!run.outcome().isFound()) {
            return run.task() + ": " + run.outcome().word();
        }
        Map<String, Object> values = run.report().values();
        List<String> words = new ArrayList<>();
        if (values.containsKey("arrived")) {
            words.add(arrivals(run));
        }
        if (values.get("abilities") instanceof List<?> abilities) {
            words.add(String.join(", ", abilities.stream().map(Object::toString).toList()));
        }
        number(values, "length", "%.2f m", words);
        number(values, "energy", "energy %.2f J", words);
        number(values, "cost", "cost %.2f", words);
        if (values.get("expanded") instanceof Long expanded) {
            words.add(String.format(Locale.ROOT, "%,d expanded", expanded));
        }
        if (values.containsKey("arrival")) {
            words.add(meetings(run));
        }
        words.add(String.format(
                Locale.ROOT,
                "%d frames, %.2f s",
                run.frames().count(),
                run.frames().duration()));
        return run.task() + ": solved: " + String.join("; ", words);
    }

    private static String arrivals(Run run) {
        Map<String, Object> values = run.report().values();
        return String.format(
                Locale.ROOT,
                "%d of %d arrived, on average after %.1f s",
                values.get("arrived"),
                values.get("agents"),
                values.get("mean_travel_s"));
    }

    /** Returns how an encounter went. */
    private static String meetings(Run run) {
        Object nearest = run.report().values().get("smallest_distance");
        return run.report().values().get("collisions") + " collisions"
                + (nearest instanceof Double metres ? String.format(Locale.ROOT, ", nearest %.2f m", metres) : "");
    }

    private static void number(Map<String, Object> values, String key, String format, List<String> words) {
        if (values.get(key) instanceof Double value) {
            words.add(String.format(Locale.ROOT, format, value));
        }
    }
}
