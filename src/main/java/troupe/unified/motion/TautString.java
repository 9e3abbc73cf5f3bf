package troupe.unified.motion;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import troupe.geometry.Line;
import troupe.geometry.Point;

/**
 * Pulls a polyline taut between its ends without leaving what a predicate allows. From each kept corner the
 * farthest point that a galloping search finds in sight comes next. Then the result is laid out finely again
 * and pulled from its other end, so that corners move to where the two tangents of an obstacle meet, until
 * that gains less than {@link #LEAST_GAIN}. Every new line is allowed by the predicate; of the old ones only
 * those stay whose replacement is not. No pass makes the whole longer, but for the small detours round a
 * step of the input that is not allowed itself. Deterministic; uses only arithmetic that is the same on
 * every machine.
 */
final class TautString {
    /** A forbidden step of the input is led round its obstacle in at most so many trials to each side. */
    private static final int DETOURS = 8;

    private static final int PASSES = 6;
    /** Gain in metres below which another pass is not worth it. */
    private static final double LEAST_GAIN = 1e-3;

    private final Sight sight;

    /** Says whether a straight line may be taken. */
    interface Sight {
        boolean allows(Line line);
    }

    TautString(Sight sight) {
        this.sight = sight;
    }

    /** Returns the taut polyline; it has the same ends. Lists of fewer than two points come back as they are. */
    List<Point> pull(List<Point> path) {
        if (path.size() < 2) {
            return List.copyOf(path);
        }
        double spacing = length(path) / (path.size() - 1) / 2;
        List<Point> corners = farthestInSight(path);
        double length = length(corners);
        boolean forwards = true;
        for (int pass = 0; pass < PASSES && corners.size() > 2; pass++) {
            List<Point> fine = laidOut(corners, spacing);
            Collections.reverse(fine);
            corners = farthestInSight(fine);
            forwards = !forwards;
            double shorter = length(corners);
            if (forwards && length - shorter < LEAST_GAIN) {
                break;
            }
            length = shorter;
        }
        if (!forwards) {
            Collections.reverse(corners);
        }
        dropNeedless(corners);
        return List.copyOf(corners);
    }

    private static double length(List<Point> path) {
        double sum = 0;
        for (int i = 1; i < path.size(); i++) {
            sum += path.get(i - 1).distance(path.get(i));
        }
        return sum;
    }

    /** Returns the corners with points between them, about {@code spacing} metres apart; a line that is not allowed gets none. */
    private List<Point> laidOut(List<Point> corners, double spacing) {
        List<Point> fine = new ArrayList<>();
        fine.add(corners.get(0));
        for (int i = 1; i < corners.size(); i++) {
            Point a = corners.get(i - 1);
            Point b = corners.get(i);
            int pieces = sees(a, b) ? (int) Math.max(1, a.distance(b) / spacing) : 1;
            for (int k = 1; k < pieces; k++) {
                double share = k / (double) pieces;
                fine.add(new Point(a.x() + share * (b.x() - a.x()), a.y() + share * (b.y() - a.y())));
            }
            fine.add(b);
        }
        return fine;
    }

    private List<Point> farthestInSight(List<Point> path) {
        List<Point> corners = new ArrayList<>();
        corners.add(path.get(0));
        int at = 0;
        while (at < path.size() - 1) {
            int next = farthest(path, at);
            if (next == at) {
                next = at + 1;
                detour(path.get(at), path.get(next), corners);
            }
            corners.add(path.get(next));
            at = next;
        }
        return corners;
    }

    /** Returns the farthest index in sight that doubling and halving finds, {@code from} if not even the next is. */
    private int farthest(List<Point> path, int from) {
        int last = path.size() - 1;
        if (sees(path, from, last)) {
            return last;
        }
        int seen = from;
        int stride = 1;
        while (from + stride < last && sees(path, from, from + stride)) {
            seen = from + stride;
            stride *= 2;
        }
        int unseen = Math.min(from + stride, last);
        while (unseen - seen > 1) {
            int middle = (seen + unseen) >>> 1;
            if (sees(path, from, middle)) {
                seen = middle;
            } else {
                unseen = middle;
            }
        }
        return seen;
    }

    private boolean sees(List<Point> path, int i, int j) {
        return sees(path.get(i), path.get(j));
    }

    private boolean sees(Point a, Point b) {
        return sight.allows(new Line(a.x(), a.y(), b.x(), b.y()));
    }

    /** Adds a point between a and b, set off to the side, by which b can be reached, if there is one near. */
    private void detour(Point a, Point b, List<Point> corners) {
        double dx = b.x() - a.x();
        double dy = b.y() - a.y();
        for (int k = 1; k <= DETOURS; k++) {
            double share = k / (2.0 * DETOURS);
            for (int side = -1; side <= 1; side += 2) {
                Point by = new Point((a.x() + b.x()) / 2 - side * share * dy, (a.y() + b.y()) / 2 + side * share * dx);
                if (sees(a, by) && sees(by, b)) {
                    corners.add(by);
                    return;
                }
            }
        }
    }

    private void dropNeedless(List<Point> corners) {
        boolean dropped = true;
        while (dropped) {
            dropped = false;
            for (int i = corners.size() - 2; i > 0; i--) {
                if (sees(corners, i - 1, i + 1)) {
                    corners.remove(i);
                    dropped = true;
                }
            }
        }
    }
}
