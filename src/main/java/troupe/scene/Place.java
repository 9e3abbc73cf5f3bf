package troupe.scene;

import java.util.OptionalDouble;

/** Holds a place to stand: metres, and the elevation {@code z}; without {@code z} the lowest span is meant. */
public record Place(double x, double y, OptionalDouble z) {

    /** Makes a place on the lowest span. */
    public static Place of(double x, double y) {
        return new Place(x, y, OptionalDouble.empty());
    }

    /** Makes a place on the span whose floor is nearest to {@code z}. */
    public static Place of(double x, double y, double z) {
        return new Place(x, y, OptionalDouble.of(z));
    }
}
