package troupe.work.explain;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.DoubleFunction;
import troupe.scene.Ability;
import troupe.scene.Preferences;

/**
 * Finds where the least-cost plan changes as the preference for one ability rises. The cost of a fixed plan
 * is a line over that preference: the energy spent with the ability is its slope. So the least cost is the
 * lower envelope of lines, and each of its corners is found by planning where two known lines cross, until
 * no plan there is cheaper than both (Eisner and Severance 1976, parametric search). Each plan made is
 * another line of the envelope, or confirms a corner. Where an obstacle is put depends on the prices, so a plan
 * that moves one need not be there at another preference: a corner at which the least cost lies above its lines
 * is none, and the search ends there.
 */
final class CostLines {
    private static final double SLACK = 1e-9;
    private static final int MOST_PLANS = 100;

    private final Ability ability;
    private final Preferences preferences;
    private final double most;
    private final DoubleFunction<Route> planner;
    private int plans;

    /**
     * Prepares the search.
     *
     * @param preferences those of the task; the one of {@code ability} is where the search begins
     * @param most the highest preference to look at
     * @param planner makes the least-cost plan for a preference for the ability
     */
    CostLines(Ability ability, Preferences preferences, double most, DoubleFunction<Route> planner) {
        this.ability = ability;
        this.preferences = preferences;
        this.most = most;
        this.planner = planner;
    }

    /**
     * Finds the corner beyond which the ability is not used any more. A plan that may use the ability and does
     * not can be cheaper than the best one without it: diagonal steps pass places where only it fits.
     *
     * @param without a plan without the ability
     */
    Optional<Flip> last(Route left, Route without) {
        Route before = left;
        Route right = without;
        while (plans < MOST_PLANS) {
            double at = crossing(before, right);
            if (Double.isNaN(at)) {
                return Optional.empty();
            }
            Route between = plan(at);
            if (!between.isFound()) {
                return Optional.empty();
            }
            if (!isCheaper(between, right, at)) {
                return isCheaper(right, between, at) ? Optional.empty() : Optional.of(flip(at, before, right));
            }
            if (between.energy(ability) > 0) {
                before = between;
            } else {
                right = between;
            }
        }
        return Optional.empty();
    }

    /**
     * Finds the first corner beyond which something else is done than in {@code left}: corners between plans
     * of the same course, which differ in where they do it, are passed over.
     */
    Optional<Flip> first(Route left, Route right) {
        Deque<Route> later = new ArrayDeque<>();
        later.push(right);
        Route before = left;
        while (!later.isEmpty() && plans < MOST_PLANS) {
            Route after = later.peek();
            double at = crossing(before, after);
            if (Double.isNaN(at)) {
                later.pop();
                continue;
            }
            Route between = plan(at);
            if (!between.isFound()) {
                return Optional.empty();
            }
            if (isCheaper(between, after, at)) {
                later.push(between);
            } else if (isCheaper(after, between, at)) {
                return Optional.empty();
            } else if (!after.course().equals(left.course())) {
                return Optional.of(flip(at, before, after));
            } else {
                before = later.pop();
            }
        }
        return Optional.empty();
    }

    private Route plan(double preference) {
        plans++;
        return planner.apply(preference);
    }

    /** Returns the preference where two plans cost the same; NaN if there is none that is looked at. */
    private double crossing(Route steeper, Route other) {
        double slope = steeper.energy(ability) - other.energy(ability);
        double at = (rest(other) - rest(steeper)) / slope;
        boolean parallel = !(slope > SLACK * steeper.energy(ability));
        return parallel || !(at <= most) ? Double.NaN : Math.max(at, preferences.of(ability));
    }

    /** Returns what a plan costs apart from the ability. */
    private double rest(Route route) {
        double sum = 0;
        for (Ability each : Ability.values()) {
            double joules = route.energy(each);
            if (each != ability && joules > 0) {
                sum += joules * preferences.of(each);
            }
        }
        return sum;
    }

    private boolean isCheaper(Route one, Route other, double preference) {
        Preferences there = preferences.with(ability, preference);
        return one.cost(there) < other.cost(there) * (1 - SLACK);
    }

    private Flip flip(double at, Route below, Route above) {
        return new Flip(ability, at, at / preferences.of(ability), below, above);
    }
}
