package troupe.unified.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import troupe.run.Channel;
import troupe.run.FrameRecorder;
import troupe.run.Frames;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Actor;

/**
 * Lets an actor travel a route and records it, {@value #RATE} frames a second, the last one at the goal.
 * Each stretch is travelled at the speed of its ability, measured along the ground. The heading follows the
 * way by at most a full turn a second, with a short look ahead; before a sidestep, a stride or a vault
 * the actor stands until it is turned as the ability asks: sideways to the way, or along it. The gait phase
 * grows by one per {@link #CYCLE} metres, and over a crossing from 0 to 1.
 *
 * <p>Channels, all of the actor: {@code x, y, z} in metres, {@code heading} in radians in (-π, π],
 * {@code ability} as the ordinal of {@link Ability}, {@code phase} in [0, 1). Used once, by one thread.
 */
public final class Motion {
    public static final double RATE = 25;
    /** The most seconds that a run can hold, less what turning may take. */
    public static final double LONGEST = 86_000;

    /** Highest rate of turning in rad/s: a full turn a second. */
    static final double TURN_RATE = 2 * Math.PI;

    /** Metres that two steps take. */
    private static final double CYCLE = 1.4;
    /** How far ahead the actor looks while it walks, in metres. */
    private static final double LOOK_AHEAD = 0.2;

    private static final double ALIGNED = 1e-9;
    private static final float JUST_BELOW_ONE = Math.nextDown(1f);

    private final Actor actor;
    private final List<Stretch> route;
    private final FrameRecorder recorder;
    private final List<Run.Leg> legs = new ArrayList<>();

    private double time;
    private double heading;
    private double phase;

    /** The stretch travelled, its line, when it was begun, and how far along the actor is in metres. */
    private int current;

    private Track track;
    private double begun;
    private double along;

    /** The turn of the body against the way while sidestepping. */
    private double sideways = Math.PI / 2;

    /** Prepares the motion of an actor along stretches that join end to end. */
    public Motion(Actor actor, List<Stretch> route) {
        this.actor = actor;
        this.route = List.copyOf(route);
        this.recorder = new FrameRecorder(RATE, channels(actor.id()));
    }

    /** Returns the channels of a run in which one actor moves. */
    public static List<Channel> channels(String actor) {
        String words = Arrays.stream(Ability.values()).map(Ability::key).collect(Collectors.joining(","));
        return List.of(
                new Channel("x", "m", Channel.Type.F64, actor, 1),
                new Channel("y", "m", Channel.Type.F64, actor, 1),
                new Channel("z", "m", Channel.Type.F64, actor, 1),
                new Channel("heading", "rad", Channel.Type.F64, actor, 1),
                new Channel("ability", words, Channel.Type.U8, actor, 1),
                new Channel("phase", "1", Channel.Type.F32, actor, 1));
    }

    /** What a motion leaves behind: its frames and its legs, one per stretch. */
    public record Recorded(Frames frames, List<Run.Leg> legs) {}

    /** Returns the seconds that the route takes besides turning in place; so many that no run can hold them are told too. */
    public double leastSeconds() {
        double seconds = 0;
        for (Stretch stretch : route) {
            seconds += stretch.length() / speed(stretch.ability());
        }
        return seconds;
    }

    /** Travels the route; without a stretch there are no frames. Cost O(frames + points). */
    public Recorded record() {
        if (!route.isEmpty()) {
            enter(0);
            heading = track.isStill() ? 0 : wanted();
            append();
            while (current < route.size()) {
                advance(1 / RATE);
                append();
            }
        }
        return new Recorded(recorder.frames(), List.copyOf(legs));
    }

    private void enter(int stretch) {
        current = stretch;
        along = 0;
        begun = time;
        track = new Track(route.get(stretch));
        if (route.get(stretch).ability() == Ability.SIDESTEP && !track.isStill()) {
            double way = track.direction(0);
            double left = Math.abs(wrapped(way + Math.PI / 2 - heading));
            double right = Math.abs(wrapped(way - Math.PI / 2 - heading));
            sideways = right < left - ALIGNED ? -Math.PI / 2 : Math.PI / 2;
        }
        if (route.get(stretch).isCrossing()) {
            phase = 0;
        }
    }

    /** Lets {@code seconds} pass: standing to turn, travelling, and going over to the next stretch. */
    private void advance(double seconds) {
        double left = seconds;
        while (left > 0 && current < route.size()) {
            double used = mustAlign() ? turn(left) : travel(left);
            left -= used;
            time += used;
            if (along >= track.length()) {
                finishStretch();
            }
        }
    }

    /** Tells whether the actor has to stand and turn before it goes on. */
    private boolean mustAlign() {
        Stretch stretch = route.get(current);
        return along == 0
                && !track.isStill()
                && (stretch.isCrossing() || stretch.ability() == Ability.SIDESTEP)
                && Math.abs(wrapped(wanted() - heading)) > ALIGNED;
    }

    private double turn(double seconds) {
        double missing = wrapped(wanted() - heading);
        double used = Math.min(seconds, Math.abs(missing) / TURN_RATE);
        heading = used < seconds ? wanted() : wrapped(heading + Math.signum(missing) * used * TURN_RATE);
        return used;
    }

    private double travel(double seconds) {
        double speed = speed(route.get(current).ability());
        double used = Math.min(seconds, (track.length() - along) / speed);
        along = used < seconds ? track.length() : along + used * speed;
        if (!track.isStill()) {
            double missing = wrapped(wanted() - heading);
            double most = used * TURN_RATE;
            heading = wrapped(heading + Math.max(-most, Math.min(most, missing)));
        }
        phase = route.get(current).isCrossing() && !track.isStill()
                ? along / track.length()
                : (phase + used * speed / CYCLE) % 1;
        return used;
    }

    private void finishStretch() {
        Stretch done = route.get(current);
        legs.add(new Run.Leg(actor.id(), done.ability().key(), done.what(), begun, time, done.energy(), done.points()));
        if (current + 1 < route.size()) {
            enter(current + 1);
        } else {
            current++;
        }
    }

    /** Returns the heading that the ability asks for here. */
    private double wanted() {
        Stretch stretch = route.get(current);
        if (stretch.ability() == Ability.SIDESTEP) {
            return wrapped(track.direction(along) + sideways);
        }
        double ahead = along + (stretch.isCrossing() ? 0 : LOOK_AHEAD);
        if (ahead > track.length()
                && current + 1 < route.size()
                && route.get(current + 1).isCrossing()) {
            return new Track(route.get(current + 1)).direction(0);
        }
        return track.bearing(along, Math.min(ahead, track.length()));
    }

    private double speed(Ability ability) {
        return switch (ability) {
            case WALK -> actor.walk().speed();
            case SIDESTEP -> actor.sidestep().orElseThrow().speed();
            case STRIDE -> actor.stride().orElseThrow().speed();
            case VAULT -> actor.vault().orElseThrow().speed();
            case MOVE -> actor.move().orElseThrow().speed();
        };
    }

    private void append() {
        double[] at = track.at(along);
        Ability ability = route.get(Math.min(current, route.size() - 1)).ability();
        recorder.append(at[0], at[1], at[2], heading, ability.ordinal(), Math.min((float) phase, JUST_BELOW_ONE));
    }

    /** Returns the angle in (-π, π]. */
    public static double wrapped(double angle) {
        double turned = angle;
        while (turned > Math.PI) {
            turned -= 2 * Math.PI;
        }
        while (turned <= -Math.PI) {
            turned += 2 * Math.PI;
        }
        return turned;
    }
}
