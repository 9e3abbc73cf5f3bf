package troupe.unified.motion;

import java.util.List;
import java.util.Optional;
import troupe.scene.Ability;

/**
 * Holds a part of a route that is travelled with one ability: consecutive steps of one way of walking, one
 * crossing, or one obstacle moved.
 *
 * @param what id of the obstacle vaulted or moved, empty otherwise
 * @param energy joules spent on it, take-off included, and what the actor walks while it holds an obstacle
 * @param points the line travelled, {@code x, y, z} in metres, at least one; z is that of the feet
 * @param haul how the obstacle moves, for the ability {@code MOVE}
 */
record Stretch(Ability ability, String what, double energy, List<double[]> points, Optional<Haul> haul) {

    /** Copies the list and checks that it is not empty. */
    Stretch {
        points = List.copyOf(points);
        if (points.isEmpty()) {
            throw new IllegalArgumentException("stretch of " + ability.key() + " without points");
        }
    }

    /** Makes a stretch in which no obstacle is moved. */
    Stretch(Ability ability, String what, double energy, List<double[]> points) {
        this(ability, what, energy, points, Optional.empty());
    }

    /** Returns the length in metres: along the ground, or of what travels farthest while an obstacle is moved. */
    double length() {
        if (haul.isPresent()) {
            return haul.get().length();
        }
        double sum = 0;
        for (int i = 1; i < points.size(); i++) {
            sum += horizontal(i);
        }
        return sum;
    }

    /** Returns the horizontal length in metres of the piece that ends at point {@code i}, {@code i >= 1}. */
    double horizontal(int i) {
        double dx = points.get(i)[0] - points.get(i - 1)[0];
        double dy = points.get(i)[1] - points.get(i - 1)[1];
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Tells whether this is a crossing: a stride or a vault. */
    boolean isCrossing() {
        return ability == Ability.STRIDE || ability == Ability.VAULT;
    }
}
