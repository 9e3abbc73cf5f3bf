package troupe.crowd;

import java.util.ArrayList;
import java.util.List;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Flock;
import troupe.crowd.flock.Kin;
import troupe.run.Report;
import troupe.scene.Crowd;

/** Tells what became of a crowd: who arrived, how long it took, by group, and what the work cost. */
final class CrowdReport {
    private final Crowd crowd;
    private final Kin kin;
    private final Agents agents;
    private long prepareNanos;
    private long moveNanos;

    CrowdReport(Crowd crowd, Kin kin, Agents agents) {
        this.crowd = crowd;
        this.kin = kin;
        this.agents = agents;
    }

    /** Takes the time of the preparation. */
    void prepared(long nanos) {
        prepareNanos += nanos;
    }

    /** Takes the time of a step. */
    void moved(long nanos) {
        moveNanos += nanos;
    }

    /** Returns the report; {@code flock} may be null if nothing has moved. */
    Report build(Flock flock) {
        Times all = times(0, agents.count);
        Report.Builder report = Report.builder()
                .put("solved", all.arrived == agents.count)
                .put("agents", agents.count)
                .put("arrived", all.arrived)
                .put("mean_travel_s", all.mean)
                .put("last_arrival_s", all.last)
                .put("motion", crowd.manner().motion().name().toLowerCase(java.util.Locale.ROOT))
                .put("split", crowd.manner().split().name().toLowerCase(java.util.Locale.ROOT));
        List<Object> groups = new ArrayList<>();
        for (Kin.Leaf leaf : kin.leaves()) {
            Times part = times(leaf.first(), leaf.first() + leaf.members().count());
            groups.add(Report.builder()
                    .put("group", leaf.group().id())
                    .put("members", leaf.members().count())
                    .put("arrived", part.arrived)
                    .put("mean_travel_s", part.mean)
                    .put("last_arrival_s", part.last)
                    .build());
        }
        report.put("groups", groups);
        if (flock != null && flock.moves() > 0) {
            report.put("visits_per_move", (double) flock.visits() / flock.moves());
        }
        report.put(
                "times_ms",
                Report.builder()
                        .put("prepare_ms", prepareNanos * 1e-6)
                        .put("steps_ms", moveNanos * 1e-6)
                        .build());
        return report.build();
    }

    /** How many have arrived, and the mean and last of their times in seconds, 0 without any. */
    private record Times(int arrived, double mean, double last) {}

    private Times times(int from, int to) {
        int arrived = 0;
        long sum = 0;
        int last = 0;
        for (int i = from; i < to; i++) {
            if (agents.arrival[i] >= 0) {
                arrived++;
                sum += agents.arrival[i];
                last = Math.max(last, agents.arrival[i]);
            }
        }
        double mean = arrived == 0 ? 0 : sum * Crowd.STEP_SECONDS / arrived;
        return new Times(arrived, mean, last * Crowd.STEP_SECONDS);
    }
}
