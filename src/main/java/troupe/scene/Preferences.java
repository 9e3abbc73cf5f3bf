package troupe.scene;

import java.util.Arrays;

/**
 * Holds, for each ability, the factor on its energy that makes its cost: 1 is neutral, larger avoids
 * it, {@link #OFF} removes it. Immutable.
 */
public final class Preferences {
    /** The factor of an ability that is not to be used. */
    public static final double OFF = Double.POSITIVE_INFINITY;

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
