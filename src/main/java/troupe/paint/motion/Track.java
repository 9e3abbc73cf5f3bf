package troupe.paint.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Obstacle;

/**
 * Follows one moving thing through the frames of a run: an actor, one member of a group, or a moved obstacle. It reads the
 * channels {@code x}, {@code y} and, where they are there, {@code z}, {@code heading} and
 * {@code ability} of one owner. Immutable.
 */
public final class Track {
    private final Frames frames;
    private final String owner;
    private final int member;
    private final int x;
    private final int y;
    private final int z;
    private final int heading;
    private final int ability;
    private final List<String> abilities;
    private final double elevation;

    private Track(Frames frames, String owner, int member, double elevation) {
        this.frames = frames;
        this.owner = owner;
        this.member = member;
        this.elevation = elevation;
        this.x = frames.channel(owner, "x");
        this.y = frames.channel(owner, "y");
        this.z = frames.channel(owner, "z");
        this.heading = frames.channel(owner, "heading");
        this.ability = frames.channel(owner, "ability");
        this.abilities = ability < 0
                ? List.of()
                : Arrays.stream(frames.channels().get(ability).unit().split(","))
                        .map(String::strip)
                        .toList();
    }

    /** Returns the tracks of all owners that have channels x and y, in the order of the channels: actors and moved obstacles. */
    public static List<Track> of(Run run) {
        return of(run, owner -> true);
    }

    /** Returns those of the tracks whose owner is one of the given. */
    static List<Track> of(Run run, Predicate<String> owners) {
        Frames frames = run.frames();
        List<Track> tracks = new ArrayList<>();
        for (Channel channel : frames.channels()) {
            if (channel.name().equals("x")
                    && owners.test(channel.owner())
                    && frames.channel(channel.owner(), "y") >= 0) {
                double elevation = run.scene()
                        .obstacle(channel.owner())
                        .map(Obstacle::offset)
                        .orElse(0.0);
                for (int member = 0; member < channel.width(); member++) {
                    tracks.add(new Track(frames, channel.owner(), member, elevation));
                }
            }
        }
        return tracks;
    }

    /** Returns the id of the element that it belongs to. */
    public String owner() {
        return owner;
    }

    /** Returns the id, with {@code -1}, {@code -2}, … for the members of a group. */
    public String id() {
        return frames.channels().get(x).width() == 1 ? owner : owner + "-" + (member + 1);
    }

    /** Returns the x in metres in a frame. */
    public double x(int frame) {
        return frames.value(frame, x, member);
    }

    /** Returns the y in metres in a frame. */
    public double y(int frame) {
        return frames.value(frame, y, member);
    }

    /** Tells whether it is there at all in a frame: one that is not has neither x nor y. */
    public boolean isThere(int frame) {
        return !(Double.isNaN(x(frame)) && Double.isNaN(y(frame)));
    }

    /** Returns the elevation in metres in a frame; if the run does not tell, that of an obstacle's bottom, else 0. */
    public double z(int frame) {
        return z < 0 ? elevation : frames.value(frame, z, member);
    }

    /** Returns the heading in radians in a frame, 0 if the run does not tell. */
    public double headingRad(int frame) {
        return heading < 0 ? 0 : frames.value(frame, heading, member);
    }

    /** Returns the word for the ability used in a frame, empty if the run does not tell. */
    public String ability(int frame) {
        if (ability < 0) {
            return "";
        }
        double code = frames.value(frame, ability, member);
        return code >= 0 && code < abilities.size() ? abilities.get((int) code) : "";
    }

    /** Returns the frame shown at a time in seconds: the last that is not later, within the run. */
    public static int frameAt(Frames frames, double time) {
        double frame = Math.floor(time * frames.rate() + 1e-6);
        return (int) Math.max(0, Math.min(frames.count() - 1.0, frame));
    }

    /** Finds an ability by its word. */
    public static Optional<Ability> ability(String word) {
        return Arrays.stream(Ability.values()).filter(a -> a.key().equals(word)).findFirst();
    }
}
