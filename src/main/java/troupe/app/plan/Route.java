package troupe.app.plan;

import java.util.Optional;
import java.util.Set;
import troupe.run.Run;
import troupe.scene.Ability;

/** Holds the plan that comes out when some abilities are switched off; empty while it is not known. */
public record Route(Set<Ability> without, Optional<Run> run) {

    /** Copies the set. */
    public Route {
        without = Set.copyOf(without);
    }
}
