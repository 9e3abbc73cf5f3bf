package troupe.work.explain;

import troupe.scene.Ability;

/**
 * Says at which preference for an ability the least-cost plan becomes another one. At that preference the
 * two cost the same.
 *
 * @param ability whose preference changes; all others stay
 * @param preference where the plan changes, above 0; as exact as the costs are, some 10⁻⁹ of them
 * @param times the same as a multiple of the preference of the task, at least 1
 * @param below the least-cost plan just below it
 * @param above the least-cost plan just above it
 */
public record Flip(Ability ability, double preference, double times, Route below, Route above) {

    /** Tells whether the ability is given up altogether: at no higher preference is it used again. */
    public boolean isGivenUp() {
        return !above.used().contains(ability);
    }
}
