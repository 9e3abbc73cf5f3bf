package troupe.work.explain;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Preferences;
import troupe.search.Outcome;

/**
 * Holds a run of a task under other preferences than the task's own.
 *
 * @param without the abilities that were switched off, none for the plan itself; in the order of {@link Ability}
 * @param run what came of it, ended
 */
public record Route(Set<Ability> without, Run run) {

    /** Copies the set. */
    public Route {
        EnumSet<Ability> copy = EnumSet.noneOf(Ability.class);
        copy.addAll(without);
        without = Collections.unmodifiableSet(copy);
    }

    /** Tells whether there is a way. */
    public boolean isFound() {
        return run.outcome().isFound();
    }

    /** Returns why there is no way, in one line; the word of the outcome where the planner gave no reason. */
    public String reason() {
        return run.outcome() instanceof Outcome.Infeasible none
                ? none.reason()
                : run.outcome().word();
    }

    /** Returns the joules spent with an ability, without preferences; 0 if the report does not tell. */
    public double energy(Ability ability) {
        return run.report().values().get("energy_by_ability") instanceof Report joules
                ? number(joules.values(), ability.key())
                : 0;
    }

    /** Returns the joules of the whole way, without preferences; 0 if the report does not tell. */
    public double energy() {
        double sum = 0;
        for (Ability ability : Ability.values()) {
            sum += energy(ability);
        }
        return sum;
    }

    /** Returns what the way costs with these preferences; an ability that it does not use may be off. */
    public double cost(Preferences preferences) {
        double sum = 0;
        for (Ability ability : Ability.values()) {
            double joules = energy(ability);
            if (joules > 0) {
                sum += joules * preferences.of(ability);
            }
        }
        return sum;
    }

    /** Returns the metres along the grid; 0 if the report does not tell. */
    public double length() {
        return number(run.report().values(), "length");
    }

    /** Returns the abilities that the way uses, in their own order; a new set. */
    public Set<Ability> used() {
        EnumSet<Ability> used = EnumSet.noneOf(Ability.class);
        for (Ability ability : Ability.values()) {
            if (run.legs().stream().anyMatch(leg -> leg.ability().equals(ability.key()))) {
                used.add(ability);
            }
        }
        return used;
    }

    /** Returns what is done one after the other, as words with the id of what it is done to: {@code vault wall}. */
    public List<String> course() {
        List<String> course = new ArrayList<>();
        for (Run.Leg leg : run.legs()) {
            String word = (leg.ability() + ' ' + leg.what()).strip();
            if (course.isEmpty() || !course.get(course.size() - 1).equals(word)) {
                course.add(word);
            }
        }
        return course;
    }

    private static double number(Map<String, Object> values, String key) {
        return values.get(key) instanceof Double value ? value : 0;
    }
}
