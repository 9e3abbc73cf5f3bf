package troupe.unified.search;

import java.util.Arrays;

/** Tells of a path what only tests ask: where its ways lead, over all search spaces. */
public final class Ways {
    private Ways() {}

    /** Returns the configurations of all ways in turn. */
    public static int[] configurations(JourneyPath path) {
        return path.parts().stream()
                .filter(JourneyPath.Way.class::isInstance)
                .flatMapToInt(way -> Arrays.stream(((JourneyPath.Way) way).configurations()))
                .toArray();
    }

    /** Returns the number of steps of all ways. */
    public static int steps(JourneyPath path) {
        return path.parts().stream()
                .filter(JourneyPath.Way.class::isInstance)
                .mapToInt(way -> ((JourneyPath.Way) way).configurations().length - 1)
                .sum();
    }
}
