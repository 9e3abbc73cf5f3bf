package troupe.app.panel;

import troupe.app.look.Texts;
import troupe.search.Outcome;

/** Says in words how a task ended. */
final class PlanWords {
    private PlanWords() {}

    /** Returns a sentence for an outcome. */
    static String outcome(Outcome outcome, Texts texts) {
        if (outcome instanceof Outcome.Infeasible infeasible) {
            return texts.format("outcome.infeasible", infeasible.reason());
        }
        return texts.get("outcome." + outcome.word());
    }
}
