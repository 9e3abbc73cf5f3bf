package troupe.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Obstacle;

/** Sums up a run for bars, tables and plots. Pure; cost O(points of the legs) each. */
public final class Figures {
    private Figures() {}

    /**
     * Consecutive legs of one ability.
     *
     * @param what id of what was vaulted or moved, empty if nothing or several things
     * @param begin the time in seconds at which it begins, {@code end} that at which it ends
     */
    public record Stretch(Optional<Ability> ability, String what, double begin, double end, double energy) {}

    /** One obstacle that was moved: its name, and the metres that its middle travelled, NaN if the run does not tell. */
    public record Move(String name, double metres) {}

    /** Returns what was moved, in order, as the report tells. */
    public static List<Move> moves(Run run) {
        List<Move> moves = new ArrayList<>();
        if (run.report().values().get("moved") instanceof List<?> moved) {
            for (Object each : moved) {
                Map<String, Object> values =
                        each instanceof Report report ? report.values() : Map.of("id", String.valueOf(each));
                String id = String.valueOf(values.get("id"));
                String name = run.scene().obstacle(id).map(Obstacle::name).orElse(id);
                moves.add(new Move(name, values.get("length") instanceof Double metres ? metres : Double.NaN));
            }
        }
        return moves;
    }

    /** Returns the energy of a run in joules. */
    public static double energy(Run run) {
        return run.legs().stream().mapToDouble(Run.Leg::energy).sum();
    }

    /** Returns the energy in joules spent with each ability, in the order of {@link Ability}. */
    public static double[] energyByAbility(Run run) {
        double[] energy = new double[Ability.values().length];
        for (Run.Leg leg : run.legs()) {
            ability(leg.ability()).ifPresent(a -> energy[a.ordinal()] += leg.energy());
        }
        return energy;
    }

    /** Returns the length in metres of the path of a run, seen from above. */
    public static double length(Run run) {
        double length = 0;
        for (Run.Leg leg : run.legs()) {
            List<double[]> points = leg.points();
            for (int i = 1; i < points.size(); i++) {
                double[] a = points.get(i - 1);
                double[] b = points.get(i);
                length += Math.hypot(b[0] - a[0], b[1] - a[1]);
            }
        }
        return length;
    }

    /** Returns the stretches of a run, one for each change of ability. */
    public static List<Stretch> stretches(Run run) {
        List<Stretch> stretches = new ArrayList<>();
        for (Run.Leg leg : run.legs()) {
            Optional<Ability> ability = ability(leg.ability());
            Stretch last = stretches.isEmpty() ? null : stretches.get(stretches.size() - 1);
            if (last != null && last.ability().equals(ability)) {
                String what = last.what().equals(leg.what()) ? last.what() : "";
                stretches.set(
                        stretches.size() - 1,
                        new Stretch(ability, what, last.begin(), leg.end(), last.energy() + leg.energy()));
            } else {
                stretches.add(new Stretch(ability, leg.what(), leg.begin(), leg.end(), leg.energy()));
            }
        }
        return stretches;
    }

    /** Returns the energy in joules spent until {@code time} seconds, even within each leg. */
    public static double energyUntil(Run run, double time) {
        double energy = 0;
        for (Run.Leg leg : run.legs()) {
            double span = leg.end() - leg.begin();
            double share = span <= 0 ? (time >= leg.begin() ? 1 : 0) : (time - leg.begin()) / span;
            energy += leg.energy() * Math.max(0, Math.min(1, share));
        }
        return energy;
    }

    /** Finds the leg under way at {@code time} seconds; the last one afterwards. */
    public static Optional<Run.Leg> legAt(Run run, double time) {
        Run.Leg last = null;
        for (Run.Leg leg : run.legs()) {
            last = leg;
            if (time < leg.end()) {
                break;
            }
        }
        return Optional.ofNullable(last);
    }

    /** Finds the ability of a word in a run. */
    public static Optional<Ability> ability(String word) {
        for (Ability ability : Ability.values()) {
            if (ability.key().equals(word)) {
                return Optional.of(ability);
            }
        }
        return Optional.empty();
    }
}
