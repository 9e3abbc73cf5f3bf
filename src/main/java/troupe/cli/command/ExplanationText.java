package troupe.cli.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import troupe.run.Json;
import troupe.run.Report;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Preferences;
import troupe.work.explain.Explanation;
import troupe.work.explain.Flip;
import troupe.work.explain.Route;

/** Puts an explanation into lines for people, or into a JSON object. */
final class ExplanationText {
    private ExplanationText() {}

    /** Returns what a person reads, a line each. */
    static List<String> lines(Explanation explanation) {
        Route plan = explanation.plan();
        List<String> lines = new ArrayList<>();
        lines.add(Planning.summary(plan.run()));
        if (!plan.isFound()) {
            return lines;
        }
        Preferences preferences = preferences(plan);
        for (Ability ability : plan.used()) {
            double joules = plan.energy(ability);
            lines.add(format("  %-10s %8.2f J  cost %8.2f", ability.key(), joules, joules * preferences.of(ability)));
        }
        for (Route route : explanation.without()) {
            lines.add(name(route.without()) + ": "
                    + (route.isFound() ? figures(route, preferences) : "no way: " + route.reason()));
        }
        for (Flip flip : explanation.flips()) {
            lines.add(format(
                            "from preference.%s=%.4g, %.4g times as much: ",
                            flip.ability().key(), flip.preference(), flip.times())
                    + (flip.isGivenUp() ? "does without it, " : "")
                    + figures(flip.above(), preferences.with(flip.ability(), flip.preference())));
        }
        return lines;
    }

    private static String figures(Route route, Preferences preferences) {
        return format(
                "%s; %.2f m; energy %.2f J; cost %.2f",
                String.join(", ", route.course()), route.length(), route.energy(), route.cost(preferences));
    }

    private static String name(Set<Ability> without) {
        return without.size() == 1 ? "without " + without.iterator().next().key() : "walking only";
    }

    /** Returns the JSON object; its keys are stable. */
    static String json(Explanation explanation) {
        Route plan = explanation.plan();
        Preferences preferences = preferences(plan);
        Report.Builder object = Report.builder().put("task", plan.run().task());
        describe(object, plan, preferences);
        object.put(
                "without",
                explanation.without().stream()
                        .map(r -> {
                            Report.Builder route = Report.builder()
                                    .put(
                                            "abilities_off",
                                            r.without().stream()
                                                    .map(Ability::key)
                                                    .toList());
                            describe(route, r, preferences);
                            return route.build();
                        })
                        .toList());
        object.put(
                "flips",
                explanation.flips().stream().map(f -> flip(f, preferences)).toList());
        return Json.of(object.build());
    }

    private static Report flip(Flip flip, Preferences preferences) {
        Preferences there = preferences.with(flip.ability(), flip.preference());
        return Report.builder()
                .put("ability", flip.ability().key())
                .put("preference", flip.preference())
                .put("times", flip.times())
                .put("given_up", flip.isGivenUp())
                .put("below", described(flip.below(), there))
                .put("above", described(flip.above(), there))
                .build();
    }

    private static Report described(Route route, Preferences preferences) {
        Report.Builder report = Report.builder();
        describe(report, route, preferences);
        return report.build();
    }

    private static void describe(Report.Builder object, Route route, Preferences preferences) {
        object.put("solved", route.isFound());
        if (!route.isFound()) {
            object.put("reason", route.reason());
            return;
        }
        Report.Builder energy = Report.builder();
        Report.Builder cost = Report.builder();
        for (Ability ability : route.used()) {
            energy.put(ability.key(), route.energy(ability));
            cost.put(ability.key(), route.energy(ability) * preferences.of(ability));
        }
        object.put("energy", route.energy())
                .put("cost", route.cost(preferences))
                .put("length", route.length())
                .put("course", route.course())
                .put("energy_by_ability", energy.build())
                .put("cost_by_ability", cost.build());
    }

    private static Preferences preferences(Route plan) {
        return plan.run().scene().task(plan.run().task()).orElseThrow() instanceof Journey journey
                ? journey.preferences()
                : Preferences.NEUTRAL;
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
