package troupe.crowd;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Kin;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;

/**
 * Records a frame for each step: for each group with members the channels x, y, z, heading and state, as wide as it
 * has members. Places are recorded exactly, elevation and heading in single precision. In a pack the directions in
 * which agents try to go change from step to step; what is recorded follows them as a body can turn, {@value #TURN} of
 * the rest in each step. The agents themselves know nothing of it.
 */
final class CrowdFrames {
    /** The share of what is left to turn that is shown in a step, and the most: 180 degrees a second. */
    private static final double TURN = 0.15;

    private static final double MOST_TURN = Math.PI * Crowd.STEP_SECONDS;

    private final Agents agents;
    /** The heading shown of each agent in radians; NaN before the first frame. */
    private final double[] shown;

    private final FrameRecorder recorder;
    private final double[] values;
    private final List<Kin.Leaf> leaves;

    CrowdFrames(Kin kin, Agents agents) {
        this.agents = agents;
        this.leaves = kin.leaves();
        List<Channel> channels = new ArrayList<>();
        for (Kin.Leaf leaf : leaves) {
            String owner = leaf.group().id();
            int width = leaf.members().count();
            channels.add(new Channel("x", "m", Channel.Type.F64, owner, width));
            channels.add(new Channel("y", "m", Channel.Type.F64, owner, width));
            channels.add(new Channel("z", "m", Channel.Type.F32, owner, width));
            channels.add(new Channel("heading", "rad", Channel.Type.F32, owner, width));
            channels.add(new Channel("state", "walking,waiting,arrived", Channel.Type.U8, owner, width));
        }
        recorder = new FrameRecorder(1 / Crowd.STEP_SECONDS, channels);
        values = new double[recorder.slots()];
        shown = new double[agents.count];
        Arrays.fill(shown, Double.NaN);
    }

    /** Adds a frame of the agents as they are. */
    void record() {
        int at = 0;
        for (Kin.Leaf leaf : leaves) {
            int count = leaf.members().count();
            int first = leaf.first();
            for (int m = 0; m < count; m++) {
                int i = first + m;
                values[at + m] = agents.x[i];
                values[at + count + m] = agents.y[i];
                values[at + 2 * count + m] = agents.z[i];
                values[at + 3 * count + m] = turned(i);
                values[at + 4 * count + m] = agents.state[i];
            }
            at += 5 * count;
        }
        recorder.append(values);
    }

    /** Turns what is shown of an agent towards where it heads; returns the angle in [-pi, pi]. */
    private double turned(int i) {
        double heading = Bearing.of(agents.headingX[i], agents.headingY[i]);
        if (Double.isNaN(shown[i])) {
            shown[i] = heading;
        } else {
            double turn = TURN * wrapped(heading - shown[i]);
            shown[i] = wrapped(shown[i] + Math.max(-MOST_TURN, Math.min(MOST_TURN, turn)));
        }
        return shown[i];
    }

    /** Returns an angle between -2 pi and 2 pi brought into [-pi, pi]. */
    private static double wrapped(double angle) {
        return angle > Math.PI ? angle - 2 * Math.PI : angle < -Math.PI ? angle + 2 * Math.PI : angle;
    }

    /** Returns the frames so far. */
    Frames frames() {
        return recorder.frames();
    }
}
