package troupe.work.inspect;

import java.util.List;
import troupe.geometry.Point;

/**
 * Says what stands between the start and the goal of a journey that has no way, as {@link BlockageSearch} finds
 * it. Immutable.
 *
 * @param obstacles ids of the obstacles and ditches that the least obstructed way crosses, in its order
 * @param gaps places on it that are too narrow
 * @param way the way, from the start to the goal
 */
public record Blockage(List<String> obstacles, List<Gap> gaps, List<Point> way) {

    /**
     * A place that is too narrow.
     *
     * @param first id of what is on one side, {@code second} on the other, empty for the border of the world
     * @param width how wide it is in metres
     * @param needed how wide it would have to be
     * @param at its narrowest place
     */
    public record Gap(String first, String second, double width, double needed, Point at) {}

    /** Copies the lists. */
    public Blockage {
        obstacles = List.copyOf(obstacles);
        gaps = List.copyOf(gaps);
        way = List.copyOf(way);
    }
}
