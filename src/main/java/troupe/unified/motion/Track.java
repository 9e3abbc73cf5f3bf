package troupe.unified.motion;

import java.util.List;
import java.util.Optional;

/**
 * Measures the line of a stretch by the metres travelled along the ground, or, while an obstacle is moved, by
 * those of what travels farthest. Immutable.
 */
final class Track {
    private final List<double[]> points;
    /** Metres from the beginning to each point. */
    private final double[] metres;

    private final Optional<Haul> haul;

    Track(Stretch stretch) {
        this.haul = stretch.haul();
        this.points = stretch.points();
        this.metres = new double[points.size()];
        for (int i = 1; i < metres.length; i++) {
            metres[i] = metres[i - 1] + stretch.horizontal(i);
        }
    }

    /** Returns the length in metres. */
    double length() {
        return haul.map(Haul::length).orElse(metres[metres.length - 1]);
    }

    /** Tells whether the line has no length, and so no direction. */
    boolean isStill() {
        return length() == 0;
    }

    /** Returns {@code x, y, z} at {@code along} metres, {@code 0 <= along <= length()}. Cost O(log points). */
    double[] at(double along) {
        if (haul.isPresent()) {
            return haul.get().actor(along);
        }
        int i = along >= length() ? metres.length - 1 : piece(along);
        double[] b = points.get(i);
        if (i == 0 || along >= metres[i]) {
            return b;
        }
        double[] a = points.get(i - 1);
        double share = (along - metres[i - 1]) / (metres[i] - metres[i - 1]);
        return new double[] {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
    }

    /** Returns the direction in radians in which the line goes on at {@code along} metres, the last one at its end. */
    double direction(double along) {
        int i = Math.max(1, piece(along));
        while (i < metres.length - 1 && metres[i] <= along) {
            i++;
        }
        while (i > 1 && metres[i] == metres[i - 1]) {
            i--;
        }
        return angle(points.get(i - 1), points.get(i));
    }

    /** Returns the direction in radians from one place of the line to a later one, the line's own where they coincide. */
    double bearing(double from, double to) {
        double[] a = at(from);
        double[] b = at(to);
        return a[0] == b[0] && a[1] == b[1] ? direction(from) : angle(a, b);
    }

    private static double angle(double[] a, double[] b) {
        return StrictMath.atan2(b[1] - a[1], b[0] - a[0]);
    }

    /** Returns the least index of a point that lies {@code along} metres or more from the beginning. */
    private int piece(double along) {
        int low = 0;
        int high = metres.length - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (metres[middle] < along) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
