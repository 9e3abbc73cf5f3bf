package troupe.app.problem;

import java.util.List;
import java.util.Optional;
import troupe.app.plan.Snapshot;
import troupe.work.inspect.Blockage;

/**
 * Holds what is known to be wrong.
 *
 * @param snapshot what was looked at
 * @param problems the problems, worst first
 * @param blockage what stands in the way, where there is no way
 * @param openings what would open it, tried out
 */
public record Findings(
        Optional<Snapshot> snapshot, List<Finding> problems, Optional<Blockage> blockage, List<Fix> openings) {
    /** Nothing is known to be wrong. */
    public static final Findings NONE = new Findings(Optional.empty(), List.of(), Optional.empty(), List.of());

    /** Copies the lists. */
    public Findings {
        problems = List.copyOf(problems);
        openings = List.copyOf(openings);
    }
}
