package troupe.unified.motion;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Line;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.unified.body.SweptBody;

/**
 * Draws the way of the feet over a crossing: straight on the ground between the two standing
 * configurations, and in height
 *
 * <ul>
 *   <li>for a vault: a smooth rise from the take-off floor to the highest top in the way, reached where the
 *       line comes over the obstacle, level until it has left it, and a smooth descent. The feet never
 *       rise above that top, because head room is promised only for a vaulting body on it;
 *   <li>for a stride: a flat parabola on the line between the two floors, as high as head room allows, at
 *       most {@link #RISE} of the length.
 * </ul>
 */
final class CrossingArc {
    /** Height of a stride's arc as a share of its length. */
    private static final double RISE = 0.1;

    private static final int PIECES = 16;

    private final SweptBody body;
    private final Actor actor;

    CrossingArc(SweptBody body, Actor actor) {
        this.body = body;
        this.actor = actor;
    }

    /** Returns the points {@code x, y, z} of a vault from floor {@code from} to floor {@code to} over obstacles. */
    List<double[]> vault(Line line, double from, double to, List<Obstacle> over) {
        double top = over.stream().mapToDouble(Obstacle::top).max().orElse(Math.max(from, to));
        double enters = 0.5;
        double leaves = 0.5;
        for (Obstacle o : over) {
            double[] stretch = inside(line, o.outline());
            enters = Math.min(enters, stretch[0]);
            leaves = Math.max(leaves, stretch[1]);
        }
        List<double[]> points = new ArrayList<>();
        for (double share : shares(enters, leaves)) {
            double z;
            if (share < enters) {
                z = from + (top - from) * smooth(share / enters);
            } else if (share > leaves) {
                z = to + (top - to) * smooth((1 - share) / (1 - leaves));
            } else {
                z = top;
            }
            points.add(at(line, share, z));
        }
        points.set(0, at(line, 0, from));
        points.set(points.size() - 1, at(line, 1, to));
        return points;
    }

    /** Returns the points {@code x, y, z} of a stride from floor {@code from} to floor {@code to}. */
    List<double[]> stride(Line line, double from, double to) {
        double room =
                body.ceiling(line, Math.max(from, to) + actor.stepHeight()) - Math.max(from, to) - actor.bodyHeight();
        double rise = Math.max(0, Math.min(room, RISE * line.length()));
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i <= PIECES; i++) {
            double share = i / (double) PIECES;
            points.add(at(line, share, from + share * (to - from) + 4 * rise * share * (1 - share)));
        }
        return points;
    }

    /** Returns the least and the greatest share of the line that lies in the polygon; {1, 0} if none does. */
    private static double[] inside(Line line, Polygon polygon) {
        double[] found = {1, 0};
        double dx = line.bx() - line.ax();
        double dy = line.by() - line.ay();
        for (int i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
            double ex = polygon.x(i) - polygon.x(j);
            double ey = polygon.y(i) - polygon.y(j);
            double cross = dx * ey - dy * ex;
            double ox = polygon.x(j) - line.ax();
            double oy = polygon.y(j) - line.ay();
            if (cross == 0) {
                continue;
            }
            double share = (ox * ey - oy * ex) / cross;
            double onEdge = (ox * dy - oy * dx) / cross;
            if (share >= 0 && share <= 1 && onEdge >= 0 && onEdge <= 1) {
                found[0] = Math.min(found[0], share);
                found[1] = Math.max(found[1], share);
            }
        }
        return found;
    }

    /** Returns shares of the way in order: ends, where the level part begins and ends, and steps of the slopes. */
    private static double[] shares(double enters, double leaves) {
        double[] shares = new double[PIECES + 2];
        int half = PIECES / 2;
        for (int i = 0; i <= half; i++) {
            shares[i] = enters * i / half;
            shares[half + 1 + i] = leaves + (1 - leaves) * i / half;
        }
        return shares;
    }

    /** Returns a smooth rise from 0 to 1, level at both ends. */
    private static double smooth(double share) {
        return share * share * (3 - 2 * share);
    }

    private static double[] at(Line line, double share, double z) {
        return new double[] {line.ax() + share * (line.bx() - line.ax()), line.ay() + share * (line.by() - line.ay()), z
        };
    }
}
