package troupe.scene;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import troupe.geometry.Polygon;

/**
 * Holds one group of a crowd: either members, or parts that are groups themselves. The list is copied.
 *
 * @param colour {@code #rrggbb}, empty for that of the group above
 * @param goal where its members go; empty for the goal of the group above
 * @param members who belongs to it directly; empty for a group of groups
 */
public record CrowdGroup(
        String id,
        String label,
        String colour,
        Optional<Place> goal,
        Optional<Members> members,
        List<CrowdGroup> parts) {

    /**
     * The agents of a group, all alike.
     *
     * @param count how many, at least 1
     * @param spawn where they stand at first
     * @param floor the elevation in metres of the floor on which they stand at first; empty for the lowest
     * @param radius of the disc of an agent, in metres
     * @param speed the highest speed in m/s
     */
    public record Members(int count, Polygon spawn, OptionalDouble floor, double radius, double speed) {
        public static final double DEFAULT_RADIUS = 0.2;
        public static final double DEFAULT_SPEED = 1.3;

        /** Makes members of the default body. */
        public static Members of(int count, Polygon spawn) {
            return new Members(count, spawn, OptionalDouble.empty(), DEFAULT_RADIUS, DEFAULT_SPEED);
        }
    }

    /** Copies the list. */
    public CrowdGroup {
        parts = List.copyOf(parts);
    }

    /** Makes a group of members without colour. */
    public static CrowdGroup of(String id, Place goal, Members members) {
        return new CrowdGroup(id, "", "", Optional.of(goal), Optional.of(members), List.of());
    }

    /** Makes a group of groups without colour. */
    public static CrowdGroup of(String id, Place goal, List<CrowdGroup> parts) {
        return new CrowdGroup(id, "", "", Optional.of(goal), Optional.empty(), parts);
    }

    /** Returns this group and all below it, each before its parts. */
    public Stream<CrowdGroup> withParts() {
        return Stream.concat(Stream.of(this), parts.stream().flatMap(CrowdGroup::withParts));
    }

    /** Returns the number of levels from this group down, 1 if it has no parts. */
    int height() {
        return 1 + parts.stream().mapToInt(CrowdGroup::height).max().orElse(0);
    }
}
