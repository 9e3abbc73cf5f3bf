package troupe.crowd;

import java.util.ArrayList;
import java.util.List;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Kin;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;

/**
 * Records a frame for each step: for each group with members the channels x, y, z, heading and state, as wide as it
 * has members. Places are recorded exactly, elevation and heading in single precision.
 */
final class CrowdFrames {
    private final Agents agents;
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
                values[at + 3 * count + m] = Bearing.of(agents.headingX[i], agents.headingY[i]);
                values[at + 4 * count + m] = agents.state[i];
            }
            at += 5 * count;
        }
        recorder.append(values);
    }

    /** Returns the frames so far. */
    Frames frames() {
        return recorder.frames();
    }
}
