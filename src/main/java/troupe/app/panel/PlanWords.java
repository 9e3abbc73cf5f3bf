package troupe.app.panel;

import java.util.Locale;
import troupe.app.look.Texts;
import troupe.search.Outcome;

/** Says in words how a task ended. */
final class PlanWords {
    private PlanWords() {}

    /** Returns a sentence for an outcome. */
    static String outcome(Outcome outcome, Texts texts) {
        if (outcome instanceof Outcome.Infeasible infeasible) {
            String reason = infeasible.reason();
            return reason.isEmpty()
                    ? texts.get("outcome.infeasible")
                    : reason.substring(0, 1).toUpperCase(Locale.ROOT) + reason.substring(1);
        }
        return texts.get("outcome." + outcome.word());
    }
}
