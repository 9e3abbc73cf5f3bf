package troupe.scene;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Holds an avatar of an encounter: a moving disc that the planner does not control. Lengths are in metres,
 * speeds in m/s, times in seconds from the start of the encounter.
 *
 * @param radius radius of the disc, above 0
 * @param speed the highest speed that the planner expects of it, above 0
 * @param mobility how fast its future blurs: the standard deviation grows by this share of itself in the first
 *     second, at least 0
 * @param kind whether the planner knows its path or only its past
 * @param motion where its motion comes from
 */
public record Avatar(
        String id,
        String label,
        String colour,
        double radius,
        double speed,
        double mobility,
        Kind kind,
        Motion motion) {
    /** The radius of an avatar that names none, in metres. */
    public static final double DEFAULT_RADIUS = 0.25;
    /** The top speed that predictions assume of an avatar that names none, in m/s. */
    public static final double DEFAULT_SPEED = 1.8;
    /** The mobility of an avatar that names none: in a second its future blurs by twice its first blur. */
    public static final double DEFAULT_MOBILITY = 2;
    /** The pace of a scripted avatar that names none, in m/s. */
    public static final double DEFAULT_PACE = 1.2;

    /** The most at which an avatar follows the person who steers it, in m/s: a run. */
    public static final double STEERED_PACE = 3;

    /** What the planner may know of an avatar. */
    public enum Kind {
        /** Only its past is known. */
        UNCERTAIN,
        /** Its whole path is known. */
        CERTAIN
    }

    /** Where the motion of an avatar comes from. */
    public sealed interface Motion {}

    /**
     * A person who steers it while the encounter runs; until then it stands at {@code start}. It follows at
     * {@link #STEERED_PACE} at most: nobody can give way to who comes out of nowhere.
     */
    public record Pointer(Place start) implements Motion {}

    /** A script: it walks straight at {@code pace} m/s from {@code start} to one goal after the other, and then stands. */
    public record Script(Place start, double pace, List<Head> heads) implements Motion {

        /** Copies the list. */
        public Script {
            heads = List.copyOf(heads);
        }
    }

    /** A goal of a script: it counts from time {@code at} on, reached or not the one before; without a time, once that one is reached. */
    public record Head(Place to, OptionalDouble at) {}

    /** Recorded positions in the order of time, straight lines between them; before the first and after the last it is not there. */
    public record Recording(List<Fix> fixes) implements Motion {

        /** Copies the list. */
        public Recording {
            fixes = List.copyOf(fixes);
        }
    }

    /** Where a recorded avatar was at a time in seconds. */
    public record Fix(double time, double x, double y) {}

    /** Makes an uncertain avatar of the default body. */
    public static Avatar of(String id, Motion motion) {
        return new Avatar(id, "", "", DEFAULT_RADIUS, DEFAULT_SPEED, DEFAULT_MOBILITY, Kind.UNCERTAIN, motion);
    }

    /** Returns this avatar as one of another kind. */
    public Avatar as(Kind other) {
        return new Avatar(id, label, colour, radius, speed, mobility, other, motion);
    }

    /** Returns the label, or the id where there is none. */
    public String name() {
        return label.isEmpty() ? id : label;
    }
}
