package troupe.app.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.plan.Plan;
import troupe.paint.motion.CrowdPainter;
import troupe.run.view.Ahead;
import troupe.run.view.Aspect;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Task;
import troupe.work.view.MomentViews;

/** Says which views there are of the run of a simulation at the moment shown, and what there is to choose. Pure. */
public final class RunViews {
    /** The aspect of the groups whose colours are shown. */
    public static final String LEVEL = "level";

    private RunViews() {}

    /** Returns the task of a plan. */
    public static Optional<Task> task(Plan plan) {
        return plan.snapshot().scene().task(plan.snapshot().task());
    }

    /** Returns the keys of the views that a plan's run has, beside those of its planner; none of journeys. */
    public static List<String> keys(Plan plan) {
        Optional<Task> task = task(plan);
        List<String> keys = new ArrayList<>();
        if (task.orElse(null) instanceof Crowd) {
            keys.addAll(List.of(OverlayChoice.TRAILS, MomentViews.DENSITY));
        } else if (task.orElse(null) instanceof Encounter) {
            keys.addAll(List.of(MomentViews.PROBABILITY, MomentViews.RISK, MomentViews.EXPECTED, MomentViews.BEFORE));
        }
        return keys;
    }

    /** Tells whether a view of the moment shown, or the run itself, stands in place of one of the planner's. */
    public static boolean replaces(Plan plan, String key) {
        List<String> keys = keys(plan);
        return keys.contains(key) || !keys.isEmpty() && key.equals(OverlayChoice.PLAN);
    }

    /** Tells whether a view of {@link #keys} is made anew for each moment. */
    public static boolean isOfMoment(String key) {
        return !key.equals(OverlayChoice.TRAILS);
    }

    /** Returns the respects in which a plan's run can be looked at, beside those of its planner. */
    public static List<Aspect> aspects(Plan plan) {
        Task task = task(plan).orElse(null);
        if (task instanceof Crowd crowd && crowd.deepest() > 1) {
            List<Aspect.Choice> choices = new ArrayList<>(List.of(Aspect.Choice.of("deepest")));
            for (int depth = 1; depth < crowd.deepest(); depth++) {
                choices.add(Aspect.Choice.of("depth", String.valueOf(depth)));
            }
            return List.of(new Aspect(LEVEL, choices, List.of(OverlayChoice.PLAN)));
        }
        return task instanceof Encounter encounter
                ? List.of(Ahead.aspect(
                        encounter.number(Quantity.HORIZON), List.of(MomentViews.PROBABILITY, MomentViews.RISK)))
                : List.of();
    }

    /** Returns the depth of the groups whose colours are shown. */
    public static int level(OverlayChoice choice) {
        int picked = choice.picked(LEVEL);
        return picked == 0 ? CrowdPainter.DEEPEST : picked;
    }

    /** Returns how many seconds ahead the avatars of a task are expected; 0 of tasks without. */
    public static double aheadSeconds(Task task, OverlayChoice choice) {
        return task instanceof Encounter encounter
                ? Ahead.seconds(encounter.number(Quantity.HORIZON), choice.picked(Ahead.KEY))
                : 0;
    }
}
