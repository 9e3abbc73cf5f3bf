package troupe.app.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.app.plan.Plan;
import troupe.app.play.Figures;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.search.Outcome;
import troupe.work.explain.Explanation;
import troupe.work.explain.Flip;

/** Says in words how a task ended, and what would change its plan. */
public final class PlanWords {
    private PlanWords() {}

    /** Returns a sentence for how a run ended. */
    public static String outcome(Run run, Texts texts) {
        return "limit.spaces".equals(run.report().values().get("limit"))
                ? texts.get("outcome.exhausted.spaces")
                : outcome(run.outcome(), texts);
    }

    /** Returns a sentence for an outcome. */
    public static String outcome(Outcome outcome, Texts texts) {
        if (outcome instanceof Outcome.Infeasible infeasible) {
            String reason = texts.tell(infeasible.reason());
            return reason.isEmpty()
                    ? texts.get("outcome.infeasible")
                    : texts.format(
                            "outcome.infeasible.because",
                            reason.substring(0, 1).toUpperCase(Locale.ROOT) + reason.substring(1));
        }
        return texts.get("outcome." + outcome.word());
    }

    /**
     * Returns how an encounter ended, the outcome first, then how near the actor came to somebody and how often they
     * touched; empty for other tasks, and where nothing was simulated or it was cancelled.
     */
    public static List<String> encounter(Run run, Texts texts) {
        boolean found = run.outcome().isFound();
        boolean ended = found || run.outcome().equals(Outcome.EXHAUSTED);
        if (!ended || !(run.scene().task(run.task()).orElse(null) instanceof Encounter)) {
            return List.of();
        }
        Map<String, Object> report = run.report().values();
        List<String> words = new ArrayList<>();
        words.add(texts.format(
                found ? "status.arrived" : "status.gaveup",
                Texts.number(run.frames().duration(), 1)));
        if (report.get("smallest_gap") instanceof Double gap && report.get("collisions") instanceof Long contacts) {
            if (contacts > 0) {
                words.add(texts.format("status.contacts", contacts));
            } else {
                words.add(texts.format("status.nearest", Texts.number(gap, 2)));
                words.add(texts.get("status.nocontact"));
            }
        }
        return words;
    }

    /** Returns how many errors keep a scene from being planned. */
    public static long errors(Plan plan) {
        return plan.problems().stream()
                .filter(p -> p.severity() == Severity.ERROR)
                .count();
    }

    /** Returns how many errors there are, and the first with its element and its cure. */
    public static String firstError(Plan plan, Texts texts) {
        return texts.format(
                "problem.first", errors(plan), problem(plan.problems().get(0), texts));
    }

    /** Returns every error with its element and its cure, an empty line between them. */
    public static String allErrors(Plan plan, Texts texts) {
        StringJoiner lines = new StringJoiner("\n\n");
        plan.problems().stream().filter(p -> p.severity() == Severity.ERROR).forEach(p -> lines.add(problem(p, texts)));
        return lines.toString();
    }

    /** Returns what is wrong, with the element and the cure, in one line. */
    public static String problem(Problem problem, Texts texts) {
        String message = texts.tell(problem.message());
        String told = problem.element().isEmpty() ? message : texts.format("problem.of", problem.element(), message);
        return problem.cure().isEmpty() ? told : texts.format("problem.cure", told, texts.tell(problem.cure()));
    }

    /** Returns what a run moves, in order, as a sentence; empty if nothing. */
    public static String moves(Run run, Texts texts) {
        StringJoiner moves = new StringJoiner(texts.get("why.then"));
        for (Figures.Move move : Figures.moves(run)) {
            moves.add(
                    Double.isNaN(move.metres())
                            ? move.name()
                            : texts.format("why.move", move.name(), Texts.number(move.metres(), 1)));
        }
        return moves.length() == 0 ? "" : texts.format("why.moves", moves);
    }

    /** Returns a sentence for each ability that a plan gives up at some preference, a line each; may be none. */
    public static String flips(Explanation explanation, Texts texts) {
        StringJoiner sentences = new StringJoiner("\n");
        for (Flip flip : explanation.flips()) {
            if (flip.isGivenUp() && flip.ability() != Ability.WALK) {
                sentences.add(flip(flip, actor(explanation.plan().run()), texts));
            }
        }
        return sentences.toString();
    }

    private static String flip(Flip flip, String actor, Texts texts) {
        double times = flip.times();
        int decimals = times < 1.95 ? 2 : times < 9.95 ? 1 : 0;
        String instead = "";
        for (Ability ability : flip.above().used()) {
            if (ability != Ability.WALK && !flip.below().used().contains(ability)) {
                String verb = texts.get("why.would." + ability.key());
                instead = instead.isEmpty() ? verb : texts.format("why.would.and", instead, verb);
            }
        }
        return texts.format(
                "why.if." + flip.ability().key(),
                Texts.number(times, decimals),
                actor,
                instead.isEmpty() ? texts.get("why.would.walk") : texts.format("why.would.instead", instead));
    }

    private static String actor(Run run) {
        return run.scene().task(run.task()).orElseThrow() instanceof Journey journey
                ? SceneEdits.name(run.scene(), journey.actor())
                : "";
    }
}
