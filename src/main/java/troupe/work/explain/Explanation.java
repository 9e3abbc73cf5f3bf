package troupe.work.explain;

import java.util.List;
import java.util.Optional;
import troupe.scene.Ability;

/**
 * Explains a plan by what else could be done. Immutable.
 *
 * @param plan the plan itself
 * @param without the best plan without each ability but walking that the plan uses, then, if it uses any, by
 *     walking only; empty if there is no plan
 * @param flips where the plan changes as the preference for an ability that it uses rises, in the order of
 *     {@link Ability} and then of the preference
 */
public record Explanation(Route plan, List<Route> without, List<Flip> flips) {

    /** Copies the lists. */
    public Explanation {
        without = List.copyOf(without);
        flips = List.copyOf(flips);
    }

    /** Returns where an ability is given up; empty if it is not used, or nothing can replace it. */
    public Optional<Flip> givenUp(Ability ability) {
        return flips.stream()
                .filter(f -> f.ability() == ability && f.isGivenUp())
                .findFirst();
    }
}
