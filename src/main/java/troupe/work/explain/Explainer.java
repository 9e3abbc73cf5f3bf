package troupe.work.explain;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Ordering;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.search.Outcome;

/**
 * Answers "what would change this plan?": plans the same journey without abilities, and finds the preferences
 * at which the plan becomes another one. Works on what reports tell of any planner: energy by ability. Costs
 * a plan for each ability used, and for each flip at least one more, as a rule under ten. Keeps nothing
 * between calls; used by the thread that calls it.
 */
public final class Explainer {
    /** How many times the preference for an ability is raised in search of another plan. */
    public static final double MOST_TIMES = 1_000;

    /** Plans tasks, where and how the caller wants it. */
    @FunctionalInterface
    public interface Planning {
        /** Plans a task to its end and returns the run; one that was cancelled if the answer is not wanted any more. */
        Run plan(Scene scene, String task);
    }

    private final Planning planning;

    /** Makes an explainer that plans by {@code planning}. */
    public Explainer(Planning planning) {
        this.planning = planning;
    }

    /**
     * Explains a run in full.
     *
     * @param plan the ended run of a task
     * @throws CancellationException if a run was cancelled
     */
    public Explanation explain(Run plan) {
        return flips(routes(plan));
    }

    /**
     * Explains a run by what comes out without abilities; flips are left out.
     *
     * @throws CancellationException if a run was cancelled
     */
    public Explanation routes(Run plan) {
        Route own = new Route(Set.of(), plan);
        List<Route> without = new ArrayList<>();
        if (own.isFound() && journey(plan).isPresent()) {
            Set<Ability> used = own.used();
            used.remove(Ability.WALK);
            for (Ability ability : used) {
                without.add(without(plan, EnumSet.of(ability)));
            }
            if (!used.isEmpty()) {
                without.add(without(plan, EnumSet.complementOf(EnumSet.of(Ability.WALK))));
            }
        }
        return new Explanation(own, without, List.of());
    }

    /**
     * Adds the flips to an explanation: for each ability that the plan uses, where something else is done
     * first, and where the ability is given up. Only for the ordering {@code optimal}: the plans of the others
     * need not be of least cost, so that no preference parts them.
     *
     * @throws CancellationException if a run was cancelled
     */
    public Explanation flips(Explanation explanation) {
        Run plan = explanation.plan().run();
        Optional<Journey> journey = journey(plan).filter(j -> j.ordering() instanceof Ordering.Optimal);
        List<Flip> flips = new ArrayList<>();
        if (journey.isPresent() && explanation.plan().isFound()) {
            for (Ability ability : explanation.plan().used()) {
                flips.addAll(flips(explanation, journey.get().preferences(), ability));
            }
        }
        return new Explanation(explanation.plan(), explanation.without(), flips);
    }

    private List<Flip> flips(Explanation explanation, Preferences preferences, Ability ability) {
        Route own = explanation.plan();
        double most = MOST_TIMES * preferences.of(ability);
        CostLines lines =
                new CostLines(ability, preferences, most, preference -> preferring(own.run(), ability, preference));
        Optional<Route> without = explanation.without().stream()
                .filter(r -> r.without().equals(Set.of(ability)) && r.isFound())
                .findFirst();
        Optional<Flip> last = without.flatMap(r -> lines.last(own, r));
        Route right = last.map(Flip::below).orElseGet(() -> preferring(own.run(), ability, most));
        List<Flip> flips = new ArrayList<>();
        if (right.isFound()) {
            lines.first(own, right).ifPresent(flips::add);
        }
        last.ifPresent(flips::add);
        return flips;
    }

    private Route without(Run plan, Set<Ability> abilities) {
        Preferences changed = journey(plan).orElseThrow().preferences();
        for (Ability ability : abilities) {
            changed = changed.with(ability, Preferences.OFF);
        }
        return new Route(abilities, again(plan, changed));
    }

    private Route preferring(Run plan, Ability ability, double preference) {
        Preferences preferences = journey(plan).orElseThrow().preferences();
        return new Route(Set.of(), again(plan, preferences.with(ability, preference)));
    }

    private Run again(Run plan, Preferences preferences) {
        Scene scene = plan.scene().with(journey(plan).orElseThrow().preferring(preferences));
        Run run = planning.plan(scene, plan.task());
        if (run.outcome().equals(Outcome.CANCELLED)) {
            throw new CancellationException("the explanation of '" + plan.task() + "' is not wanted any more");
        }
        return run;
    }

    private static Optional<Journey> journey(Run plan) {
        return plan.scene().task(plan.task()).map(t -> t instanceof Journey j ? j : null);
    }
}
