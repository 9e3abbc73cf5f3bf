package troupe.crowd;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Obstacle;

/**
 * Checks a run of a crowd without the simulator: every pair of agents in every frame, and every agent against every
 * obstacle, on the recorded numbers.
 */
final class Legality {
    /** Metres by which rounding may bring two things too near. */
    static final double SLACK = 1e-9;

    private final Run run;
    private final Crowd crowd;
    private final List<int[]> channels = new ArrayList<>();
    private final List<Double> radii = new ArrayList<>();
    private final List<String> names = new ArrayList<>();

    Legality(Run run) {
        this.run = run;
        this.crowd = (Crowd) run.scene().task(run.task()).orElseThrow();
        Frames frames = run.frames();
        for (CrowdGroup group : crowd.allGroups().toList()) {
            int count = group.members().map(CrowdGroup.Members::count).orElse(0);
            for (int m = 0; m < count; m++) {
                channels.add(new int[] {
                    frames.channel(group.id(), "x"), frames.channel(group.id(), "y"), frames.channel(group.id(), "z"), m
                });
                radii.add(group.members().orElseThrow().radius());
                names.add(group.id() + "-" + (m + 1));
            }
        }
    }

    /** Returns the number of agents. */
    int agents() {
        return radii.size();
    }

    /** Returns the first fault of any frame, nothing if there is none. Cost O(frames agents (agents + corners)). */
    Optional<String> fault() {
        int n = radii.size();
        double[] x = new double[n];
        double[] y = new double[n];
        double[] z = new double[n];
        for (int frame = 0; frame < run.frames().count(); frame++) {
            for (int i = 0; i < n; i++) {
                int[] at = channels.get(i);
                x[i] = run.frames().value(frame, at[0], at[3]);
                y[i] = run.frames().value(frame, at[1], at[3]);
                z[i] = run.frames().value(frame, at[2], at[3]);
            }
            for (int i = 0; i < n; i++) {
                String pair = pair(x, y, z, i);
                String wall = pair.isEmpty() ? wall(x[i], y[i], z[i], radii.get(i)) : "";
                if (!pair.isEmpty() || !wall.isEmpty()) {
                    return Optional.of("frame " + frame + ": " + names.get(i) + pair + wall);
                }
            }
        }
        return Optional.empty();
    }

    private String pair(double[] x, double[] y, double[] z, int i) {
        double radius = radii.get(i);
        for (int j = 0; j < i; j++) {
            double reach = radius + radii.get(j) - SLACK;
            double dx = x[i] - x[j];
            double dy = y[i] - y[j];
            boolean level = Math.abs(z[i] - z[j]) < crowd.manner().bodyHeight() - 1e-6;
            if (dx * dx + dy * dy < reach * reach && level) {
                return " overlaps " + names.get(j) + " by " + (reach - Math.sqrt(dx * dx + dy * dy));
            }
        }
        return "";
    }

    private String wall(double x, double y, double z, double radius) {
        boolean inside = x >= radius - SLACK
                && y >= radius - SLACK
                && x <= run.scene().world().width() - radius + SLACK
                && y <= run.scene().world().depth() - radius + SLACK;
        if (!inside) {
            return " leaves the world at " + x + "," + y;
        }
        for (Obstacle o : run.scene().obstacles()) {
            boolean level = o.top() > z + crowd.manner().stepHeight() + 1e-6
                    && o.offset() < z + crowd.manner().bodyHeight() - 1e-6;
            if (level && o.outline().distance(x, y) < radius - SLACK) {
                return " stands in " + o.id() + " at " + x + "," + y + "," + z;
            }
        }
        return "";
    }
}
