package troupe.risk;

import java.util.Arrays;
import troupe.run.Report;
import troupe.run.frame.Frames;
import troupe.scene.Encounter;

/** Gathers what a report of an encounter tells. */
final class EncounterReport {
    private final Encounter encounter;
    private final long[] actions = new long[Action.values().length];
    private long[] nanos = new long[256];
    private int decisions;
    private long preparation;
    private long expanded;
    private double length;
    private double risks;
    private double peak;
    private double nearest = Double.POSITIVE_INFINITY;
    private double gap = Double.POSITIVE_INFINITY;
    private double deviation;
    private long collisions;

    EncounterReport(Encounter encounter) {
        this.encounter = encounter;
    }

    void prepared(long took) {
        preparation = took;
    }

    void decided(Action action, long took, long expansions) {
        actions[action.ordinal()]++;
        if (decisions == nanos.length) {
            nanos = Arrays.copyOf(nanos, 2 * decisions);
        }
        nanos[decisions++] = took;
        expanded = expansions;
    }

    void risk(double mean) {
        risks += mean;
        peak = Math.max(peak, mean);
    }

    void walked(double way, double x, double y) {
        length += way;
        double dx = encounter.goal().x() - encounter.start().x();
        double dy = encounter.goal().y() - encounter.start().y();
        double straight = Math.sqrt(dx * dx + dy * dy);
        if (straight > 0) {
            double off = dx * (y - encounter.start().y())
                    - dy * (x - encounter.start().x());
            deviation = Math.max(deviation, Math.abs(off) / straight);
        }
    }

    void apart(double middles, double surfaces, boolean collides) {
        nearest = Math.min(nearest, middles);
        gap = Math.min(gap, surfaces);
        collisions += collides ? 1 : 0;
    }

    Report build(boolean arrived, Frames frames) {
        double dx = encounter.goal().x() - encounter.start().x();
        double dy = encounter.goal().y() - encounter.start().y();
        double straight = Math.sqrt(dx * dx + dy * dy);
        Report.Builder did = Report.builder();
        for (Action action : Action.values()) {
            did.put(action.key(), actions[action.ordinal()]);
        }
        Report.Builder report = Report.builder()
                .put("solved", arrived)
                .put("length", length)
                .put("expanded", expanded)
                .put("times_ms", times())
                .put("frames", frames.count())
                .put("duration", frames.duration())
                .put("arrival", arrived ? frames.duration() : 0.0)
                .put("straight", straight)
                .put("detour", arrived && straight > 0 ? length / straight : 0.0)
                .put("deviation", deviation)
                .put("collisions", collisions);
        if (nearest < Double.POSITIVE_INFINITY) {
            report.put("smallest_distance", nearest).put("smallest_gap", gap);
        }
        return report.put("mean_risk", decisions == 0 ? 0 : risks / decisions)
                .put("peak_risk", peak)
                .put("actions", did.build())
                .build();
    }

    private Report times() {
        long[] later = Arrays.copyOfRange(nanos, Math.min(1, decisions), decisions);
        Arrays.sort(later);
        return Report.builder()
                .put("preparation", preparation * 1e-6)
                .put("first_plan", decisions == 0 ? 0 : nanos[0] * 1e-6)
                .put("step_median", rank(later, 0.5))
                .put("step_p99", rank(later, 0.99))
                .build();
    }

    private static double rank(long[] sorted, double share) {
        return sorted.length == 0 ? 0 : sorted[(int) Math.min(sorted.length - 1.0, share * sorted.length)] * 1e-6;
    }
}
