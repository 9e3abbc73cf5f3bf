package troupe.risk;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.risk.plan.TimedPath;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Channel.Type;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;

/**
 * Records the frames of an encounter. Of the actor: {@code x}, {@code y}, {@code heading}, the mean {@code risk} of
 * its plan, the {@code action} taken, and the plan itself, {@value #POINTS} points {@code plan.x}, {@code plan.y},
 * {@code plan.t} evenly along its length. Of each avatar: {@code x}, {@code y}, {@code heading}, NaN where it is
 * not there.
 */
public final class EncounterFrames {
    /** The points of a plan in a frame. */
    public static final int POINTS = 48;

    private static final int FIXED = 5;

    private final Encounter encounter;
    private final Actor actor;
    private final FrameRecorder recorder;
    private final double[] values;
    private final double[] lastX;
    private final double[] lastY;
    private final double[] headings;
    private final List<double[]> way = new ArrayList<>();

    EncounterFrames(Encounter encounter, Actor actor) {
        this.encounter = encounter;
        this.actor = actor;
        List<Channel> channels = new ArrayList<>(List.of(
                new Channel("x", "m", Type.F64, actor.id(), 1),
                new Channel("y", "m", Type.F64, actor.id(), 1),
                new Channel("heading", "rad", Type.F32, actor.id(), 1),
                new Channel("risk", "", Type.F32, actor.id(), 1),
                new Channel("action", Action.words(), Type.U8, actor.id(), 1),
                new Channel("plan.x", "m", Type.F32, actor.id(), POINTS),
                new Channel("plan.y", "m", Type.F32, actor.id(), POINTS),
                new Channel("plan.t", "s", Type.F32, actor.id(), POINTS)));
        for (Avatar avatar : encounter.avatars()) {
            channels.add(new Channel("x", "m", Type.F64, avatar.id(), 1));
            channels.add(new Channel("y", "m", Type.F64, avatar.id(), 1));
            channels.add(new Channel("heading", "rad", Type.F32, avatar.id(), 1));
        }
        recorder = new FrameRecorder(encounter.number(Quantity.RATE), channels);
        values = new double[recorder.slots()];
        int count = encounter.avatars().size();
        lastX = new double[count];
        lastY = new double[count];
        headings = new double[count];
        Arrays.fill(lastX, Double.NaN);
    }

    /** What an actor is and does in a step: place in metres, heading in radians, mean risk of its plan, action. */
    record State(double x, double y, double heading, double risk, Action action) {}

    /** Adds the frame of a time in seconds. */
    void add(State actorNow, TimedPath plan, List<Course> courses, double now) {
        values[0] = actorNow.x();
        values[1] = actorNow.y();
        values[2] = actorNow.heading();
        values[3] = actorNow.risk();
        values[4] = actorNow.action().ordinal();
        sample(plan);
        int slot = FIXED + 3 * POINTS;
        for (int a = 0; a < courses.size(); a++) {
            double ax = courses.get(a).x(now);
            double ay = courses.get(a).y(now);
            double dx = ax - lastX[a];
            double dy = ay - lastY[a];
            if (dx * dx + dy * dy > 1e-12) {
                headings[a] = StrictMath.atan2(dy, dx);
            }
            lastX[a] = ax;
            lastY[a] = ay;
            values[slot++] = ax;
            values[slot++] = ay;
            values[slot++] = headings[a];
        }
        recorder.append(values);
        way.add(new double[] {actorNow.x(), actorNow.y(), 0});
    }

    private void sample(TimedPath plan) {
        double length = plan.length();
        int i = 0;
        double before = 0;
        for (int k = 0; k < POINTS; k++) {
            double at = length * k / (POINTS - 1);
            while (i + 2 < plan.size() && before + plan.length(i, i + 1) < at) {
                before += plan.length(i, i + 1);
                i++;
            }
            boolean more = i + 1 < plan.size();
            double piece = more ? plan.length(i, i + 1) : 0;
            double share = piece > 0 ? Math.min(1, (at - before) / piece) : 0;
            int next = more ? i + 1 : i;
            values[FIXED + k] = plan.x(i) + share * (plan.x(next) - plan.x(i));
            values[FIXED + POINTS + k] = plan.y(i) + share * (plan.y(next) - plan.y(i));
            values[FIXED + 2 * POINTS + k] = plan.t(i) + share * (plan.t(next) - plan.t(i));
        }
    }

    Frames frames() {
        return recorder.frames();
    }

    /** Returns the way walked so far as one leg, none before the actor has moved. */
    List<Run.Leg> legs() {
        if (way.size() < 2) {
            return List.of();
        }
        double end = (way.size() - 1) / encounter.number(Quantity.RATE);
        double length = 0;
        for (int k = 1; k < way.size(); k++) {
            double dx = way.get(k)[0] - way.get(k - 1)[0];
            double dy = way.get(k)[1] - way.get(k - 1)[1];
            length += Math.sqrt(dx * dx + dy * dy);
        }
        double energy = length * actor.walk().energy();
        return List.of(new Run.Leg(actor.id(), Ability.WALK.key(), "", 0, end, energy, List.copyOf(way)));
    }
}
