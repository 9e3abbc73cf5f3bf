package troupe.unified.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import troupe.geometry.Pose;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Actor;

/**
 * Lets an actor travel a route and records it, {@value #RATE} frames a second, the last one at the goal.
 * Each stretch is travelled at the speed of its ability, measured along the ground. The heading follows the
 * way by at most a full turn a second, with a short look ahead; before a sidestep, a stride or a vault
 * the actor stands until it is turned as the ability asks: sideways to the way, or along it. The gait phase
 * grows by one per {@link #CYCLE} metres, and over a crossing from 0 to 1.
 *
 * <p>Channels, first of the actor: {@code x, y, z} in metres, {@code heading} in radians in (-π, π],
 * {@code ability} as the ordinal of {@link Ability}, {@code phase} in [0, 1). Then, for each obstacle that is
 * moved, in document order, {@code x, y} of its centroid in metres and {@code heading} in radians, 0 as drawn,
 * without jumps. While it moves an obstacle the actor faces its hold, or what it moves without a grip. Used
 * once, by one thread.
 */
public final class Motion {
    /** Frames per second. */
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

    /** What is moved, in the order of the channels. */
    private final List<Haul> hauls;

    private final double[] values;

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
        this.hauls = this.route.stream()
                .flatMap(stretch -> stretch.haul().stream())
                .sorted(Comparator.comparingInt(haul -> haul.movable().number()))
                .toList();
        this.recorder = new FrameRecorder(
                RATE,
                channels(
                        actor.id(),
                        hauls.stream()
                                .map(haul -> haul.movable().obstacle().id())
                                .toList()));
        this.values = new double[6 + 3 * hauls.size()];
    }

    /** Returns the channels of a run in which one actor moves, and moves obstacles. */
    public static List<Channel> channels(String actor, List<String> obstacles) {
        String words = Arrays.stream(Ability.values()).map(Ability::key).collect(Collectors.joining(","));
        List<Channel> channels = new ArrayList<>(List.of(
                new Channel("x", "m", Channel.Type.F64, actor, 1),
                new Channel("y", "m", Channel.Type.F64, actor, 1),
                new Channel("z", "m", Channel.Type.F64, actor, 1),
                new Channel("heading", "rad", Channel.Type.F64, actor, 1),
                new Channel("ability", words, Channel.Type.U8, actor, 1),
                new Channel("phase", "1", Channel.Type.F32, actor, 1)));
        for (String obstacle : obstacles) {
            channels.add(new Channel("x", "m", Channel.Type.F64, obstacle, 1));
            channels.add(new Channel("y", "m", Channel.Type.F64, obstacle, 1));
            channels.add(new Channel("heading", "rad", Channel.Type.F64, obstacle, 1));
        }
        return List.copyOf(channels);
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
                && (stretch.isCrossing() || stretch.ability() == Ability.SIDESTEP || stretch.ability() == Ability.MOVE)
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
        Stretch stretch = route.get(current);
        boolean gripped = stretch.haul().filter(Haul::isGripped).isPresent();
        if (gripped) {
            heading = wanted();
        } else if (!track.isStill()) {
            double missing = wrapped(wanted() - heading);
            double most = used * TURN_RATE;
            heading = wrapped(heading + Math.max(-most, Math.min(most, missing)));
        }
        if (stretch.isCrossing() && !track.isStill()) {
            phase = along / track.length();
        } else if (gripped || stretch.haul().isEmpty()) {
            phase = (phase + used * speed / CYCLE) % 1;
        }
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
        if (stretch.haul().isPresent()) {
            return stretch.haul().get().facing(along);
        }
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
        System.arraycopy(at, 0, values, 0, 3);
        values[3] = heading;
        values[4] = ability.ordinal();
        values[5] = Math.min((float) phase, JUST_BELOW_ONE);
        for (int i = 0; i < hauls.size(); i++) {
            Pose pose = hauls.get(i).obstacle(hauled(hauls.get(i)));
            values[6 + 3 * i] = pose.x();
            values[7 + 3 * i] = pose.y();
            values[8 + 3 * i] = pose.headingRad();
        }
        recorder.append(values);
    }

    /** Returns how far a haul has come by now: 0 before its stretch is begun, all of it afterwards. */
    private double hauled(Haul haul) {
        for (int i = 0; i < current; i++) {
            if (route.get(i).haul().filter(h -> h == haul).isPresent()) {
                return haul.length();
            }
        }
        boolean under = current < route.size()
                && route.get(current).haul().filter(h -> h == haul).isPresent();
        return under ? along : 0;
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
