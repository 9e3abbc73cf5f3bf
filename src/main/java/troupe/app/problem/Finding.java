package troupe.app.problem;

import java.util.List;
import troupe.scene.check.Problem;

/** Holds a problem with the fixes at hand, the best first. */
public record Finding(Problem problem, List<Fix> fixes) {

    /** Copies the list. */
    public Finding {
        fixes = List.copyOf(fixes);
    }
}
