package troupe.unified.motion;

import java.util.List;
import troupe.scene.Ability;

/**
 * Holds a part of a route that is travelled with one ability: consecutive steps of one way of walking, or
 * one crossing.
 *
 * @param what id of the obstacle vaulted, empty otherwise
 * @param energy joules spent on it, take-off included
 * @param points the line travelled, {@code x, y, z} in metres, at least one; z is that of the feet
 */
record Stretch(Ability ability, String what, double energy, List<double[]> points) {

    /** Copies the list and checks that it is not empty. */
    Stretch {
        points = List.copyOf(points);
        if (points.isEmpty()) {
            throw new IllegalArgumentException("stretch of " + ability.key() + " without points");
        }
    }

    /** Returns the horizontal length in metres. */
    double length() {
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
