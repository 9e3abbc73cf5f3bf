package troupe.scene;

import java.util.Arrays;

/**
 * Holds, for each ability, the factor on its energy that makes its cost: 1 is neutral, larger avoids
 * it, {@link #OFF} removes it. Immutable.
 */
public final class Preferences {
    /** The factor of an ability that is not to be used. */
    public static final double OFF = Double.POSITIVE_INFINITY;

    /** The largest {@link #spread} with which costs can be added up exactly. */
    public static final double WIDEST = 1e12;

    /** Every factor 1. */
    public static final Preferences NEUTRAL = new Preferences(ones());

    private final double[] factors;

    private Preferences(double[] factors) {
        this.factors = factors;
    }

    private static double[] ones() {
        double[] ones = new double[Ability.values().length];
        Arrays.fill(ones, 1);
        return ones;
    }

    /** Returns the factor of an ability, {@code > 0}, {@link #OFF} if it is removed. */
    public double of(Ability ability) {
        return factors[ability.ordinal()];
    }

    /** Tells whether the ability may be used. */
    public boolean allows(Ability ability) {
        return of(ability) != OFF;
    }

    /**
     * Returns how many times the dearest step of an actor costs the cheapest straight one, over cells of
     * {@code cell} metres: a diagonal step and a take-off of the dearest ability that these preferences
     * allow; at least 1, NaN if a number of the actor is. Moving obstacles is no step.
     */
    public double spread(Actor actor, double cell) {
        double[] steps = {Double.POSITIVE_INFINITY, 0};
        widen(steps, Ability.WALK, actor.walk().energy(), 0, cell);
        actor.sidestep().ifPresent(a -> widen(steps, Ability.SIDESTEP, a.energy(), 0, cell));
        actor.stride().ifPresent(a -> widen(steps, Ability.STRIDE, a.energy(), a.takeOff(), cell));
        actor.vault().ifPresent(a -> widen(steps, Ability.VAULT, a.energy(), a.takeOff(), cell));
        double cheapest = steps[0] == Double.POSITIVE_INFINITY ? cell : steps[0];
        return Math.max(1, steps[1] / cheapest);
    }

    private void widen(double[] steps, Ability ability, double energy, double takeOff, double cell) {
        if (allows(ability)) {
            double straight = energy * of(ability) * cell;
            if (straight != 0) {
                steps[0] = Math.min(steps[0], straight);
            }
            steps[1] = Math.max(steps[1], straight * Math.sqrt(2) + takeOff * of(ability));
        }
    }

    /**
     * Returns these preferences with one factor changed.
     *
     * @throws IllegalArgumentException if the factor is not {@code > 0}
     */
    public Preferences with(Ability ability, double factor) {
        if (!(factor > 0)) {
            throw new IllegalArgumentException(
                    "preference." + ability.key() + "=" + factor + "; needs a number above 0, or off");
        }
        double[] changed = factors.clone();
        changed[ability.ordinal()] = factor;
        return new Preferences(changed);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Preferences p && Arrays.equals(factors, p.factors);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(factors);
    }

    @Override
    public String toString() {
        return "Preferences" + Arrays.toString(factors);
    }
}
