package troupe.unified;

import java.util.ArrayList;
import java.util.List;
import troupe.run.Frames;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.unified.search.JourneyPath;

/**
 * Writes the report of a journey. Its keys are the same whether a way was found or not; without a way the
 * numbers of the way are 0 and its lists empty. {@code energy}, {@code cost} and {@code length} are those of
 * the way over the grid, {@code smoothed_length} is what the actor travels.
 */
final class JourneyReport {
    private final StageTimes times;
    private final Frames frames;
    private final List<Run.Leg> legs;
    private long expanded;
    private long generated;
    private JourneyPath path = new JourneyPath(List.of(), 0, 0, zeros(), zeros());
    private boolean solved;
    private double reachedArea;
    private List<String> blockedBy = List.of();
    private List<String> blockedTogether = List.of();
    private List<String> wouldHelp = List.of();

    JourneyReport(StageTimes times, Frames frames, List<Run.Leg> legs) {
        this.times = times;
        this.frames = frames;
        this.legs = legs;
    }

    private static double[] zeros() {
        return new double[Ability.values().length];
    }

    /** Puts down the work of the search. */
    void searched(long labelsExpanded, long labelsGenerated) {
        expanded = labelsExpanded;
        generated = labelsGenerated;
    }

    /** Puts down the way. */
    void found(JourneyPath found) {
        path = found;
        solved = true;
    }

    /** Puts down what keeps start and goal apart. */
    void separated(double squareMetres, List<String> blockers, List<String> together, List<String> helpful) {
        reachedArea = squareMetres;
        blockedBy = blockers;
        blockedTogether = together;
        wouldHelp = helpful;
    }

    Report build() {
        Report.Builder report = Report.builder()
                .put("solved", solved)
                .put("energy", path.energy())
                .put("cost", path.cost())
                .put("length", path.length())
                .put("smoothed_length", smoothedLength())
                .put("abilities", abilities())
                .put("energy_by_ability", byAbility(path.energyByAbility()))
                .put("cost_by_ability", byAbility(path.costByAbility()))
                .put("take_offs", path.takeOffs())
                .put("moved", List.of())
                .put("expanded", expanded)
                .put("generated", generated)
                .put("times_ms", times.report())
                .put("frames", frames.count())
                .put("duration", frames.duration());
        if (!solved) {
            report.put("reached_area", reachedArea)
                    .put("blocked_by", blockedBy)
                    .put("blocked_together", blockedTogether)
                    .put("would_help", wouldHelp);
        }
        return report.build();
    }

    /** Returns the abilities in the order of their use, one entry for legs of the same ability in a row. */
    private List<String> abilities() {
        List<String> used = new ArrayList<>();
        for (Run.Leg leg : legs) {
            if (leg.points().size() > 1
                    && (used.isEmpty() || !used.get(used.size() - 1).equals(leg.ability()))) {
                used.add(leg.ability());
            }
        }
        return used;
    }

    private double smoothedLength() {
        double sum = 0;
        for (Run.Leg leg : legs) {
            for (int i = 1; i < leg.points().size(); i++) {
                double[] a = leg.points().get(i - 1);
                double[] b = leg.points().get(i);
                sum += Math.sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]));
            }
        }
        return sum;
    }

    /** Returns the joules of each ability that takes any. */
    private static Report byAbility(double[] joules) {
        Report.Builder report = Report.builder();
        for (Ability ability : Ability.values()) {
            if (joules[ability.ordinal()] > 0) {
                report.put(ability.key(), joules[ability.ordinal()]);
            }
        }
        return report.build();
    }
}
