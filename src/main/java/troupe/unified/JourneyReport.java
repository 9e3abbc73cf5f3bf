package troupe.unified;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Pose;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.search.Outcome;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.search.JourneyPath;
import troupe.unified.search.JourneySearch;
import troupe.unified.search.MoveAttempt;
import troupe.unified.search.SearchSpace;

/**
 * Writes the report of a journey. Its keys are the same whether a way was found or not; without a way the
 * numbers of the way are 0 and its lists empty. {@code energy}, {@code cost} and {@code length} are those of
 * the way over the grid, {@code smoothed_length} is what the actor travels.
 */
final class JourneyReport {
    private final StageTimes times;
    private final Frames frames;
    private final List<Run.Leg> legs;
    private JourneySearch search;
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
    void searched(JourneySearch done) {
        search = done;
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
                .put("moved", moved())
                .put("transit_length", path.length() - path.transferLength())
                .put("transfer_length", path.transferLength())
                .put("expanded", search == null ? 0L : search.expanded())
                .put("generated", search == null ? 0L : search.generated())
                .put("spaces", spaces())
                .put("instances", instances())
                .put("times_ms", times.report())
                .put("frames", frames.count())
                .put("duration", frames.duration());
        if (!solved) {
            report.put("reached_area", reachedArea)
                    .put("blocked_by", blockedBy)
                    .put("blocked_together", blockedTogether)
                    .put("would_help", wouldHelp);
        }
        if (search != null && search.outcome() instanceof Outcome.Exhausted) {
            report.put("limit", search.isCrowded() ? "limit.spaces" : "limit.expansions");
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

    /** Returns what was moved, in order: where its centroid was and is, in metres, and how far it travelled and turned. */
    private List<Report> moved() {
        List<Report> moved = new ArrayList<>();
        for (JourneyPath.Push push : path.pushes()) {
            moved.add(Report.builder()
                    .put("id", push.movable().obstacle().id())
                    .put("from", place(push.movable().pose(LatticePose.HOME)))
                    .put("to", place(push.movable().pose(push.transfer().last())))
                    .put(
                            "heading",
                            Math.toDegrees(
                                    push.movable().pose(push.transfer().last()).headingRad()))
                    .put("length", push.transfer().length())
                    .put("turn", Math.toDegrees(push.transfer().turn()))
                    .build());
        }
        return moved;
    }

    private static List<Double> place(Pose pose) {
        return List.of(pose.x(), pose.y());
    }

    /** Returns for each search space what has been moved in it and the labels that it got. */
    private List<Report> spaces() {
        List<Report> spaces = new ArrayList<>();
        for (SearchSpace space : search == null ? List.<SearchSpace>of() : search.spaces()) {
            List<String> moved =
                    space.moved().stream().map(m -> m.obstacle().id()).toList();
            spaces.add(Report.builder()
                    .put("moved", moved)
                    .put("expanded", space.expanded())
                    .put("generated", space.generated())
                    .build());
        }
        return spaces;
    }

    /** Returns how many manipulation instances there were, how often they were gone on with, and how they ended. */
    private Report instances() {
        long established = 0;
        long resumed = 0;
        long finished = 0;
        long failed = 0;
        for (SearchSpace space : search == null ? List.<SearchSpace>of() : search.spaces()) {
            for (MoveAttempt attempt : space.attempts()) {
                established++;
                resumed += Math.max(0, attempt.turns() - 1);
                finished += attempt.outcome().isFound() ? 1 : 0;
                failed += attempt.outcome() instanceof Outcome.Infeasible ? 1 : 0;
            }
        }
        return Report.builder()
                .put("established", established)
                .put("resumed", resumed)
                .put("finished", finished)
                .put("failed", failed)
                .put("expanded", search == null ? 0L : search.manipulated())
                .build();
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
