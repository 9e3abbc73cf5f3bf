package troupe.unified;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Point;
import troupe.grid.GridFrame;
import troupe.grid.Kind;
import troupe.grid.Region;
import troupe.grid.Spans;
import troupe.scene.Ability;
import troupe.unified.SweptBody.Line;

/**
 * Pulls the standing parts of a grid path taut within their classes. A line is taken only if every cell
 * that it passes (at a corner, both cells beside it too) holds a span of the same class and floor on which
 * the same ability can be used, and if on the polygons the body keeps its radius all along and the feet
 * rest: on that one floor where the class is stable, over no drop where it is border.
 *
 * <p>Steps of the grid at which class or floor change stay as they are, and so do steps for which neither
 * they nor a small detour pass that test. On those the body may come nearer to a corner than its radius r,
 * by at most {@code r - sqrt(r² - s²/4)}, s the length of the step, because only its ends keep r.
 */
final class Smoothing {
    private final Region region;
    private final SweptBody body;

    Smoothing(Region region, SweptBody body) {
        this.region = region;
        this.body = body;
    }

    /**
     * Returns the smoothed line, {@code x, y, z} in metres, of a part of a path that is travelled with one
     * ability on spans; it keeps both ends.
     *
     * @param path configurations of spans, each a neighbour of the one before
     */
    List<double[]> smoothed(int[] path, Ability ability) {
        List<double[]> points = new ArrayList<>();
        int begin = 0;
        for (int i = 1; i <= path.length; i++) {
            if (i == path.length || !isAlike(path[begin], path[i])) {
                double floor = region.elevation(path[begin]);
                if (begin > 0) {
                    addStep(path[begin - 1], path[begin], points);
                }
                for (Point p : taut(path, begin, i, ability)) {
                    add(points, p.x(), p.y(), floor);
                }
                begin = i;
            }
        }
        return points;
    }

    private boolean isAlike(int a, int b) {
        return region.kind(a) == region.kind(b) && region.elevation(a) == region.elevation(b);
    }

    private List<Point> taut(int[] path, int from, int to, Ability ability) {
        List<Point> centres = new ArrayList<>();
        for (int i = from; i < to; i++) {
            centres.add(new Point(region.x(path[i]), region.y(path[i])));
        }
        Ground ground = new Ground(region.kind(path[from]), region.elevation(path[from]), ability);
        return new TautString(line -> isFree(line, ground)).pull(centres);
    }

    /** Adds the point of a step at which the floor changes, on the higher floor. */
    private void addStep(int from, int to, List<double[]> points) {
        double low = Math.min(region.elevation(from), region.elevation(to));
        double high = Math.max(region.elevation(from), region.elevation(to));
        if (low == high) {
            return;
        }
        boolean rises = region.elevation(to) == high;
        int lower = rises ? from : to;
        int upper = rises ? to : from;
        double on = 0;
        double off = 1;
        for (int k = 0; k < 40; k++) {
            double share = (on + off) / 2;
            double x = region.x(upper) + share * (region.x(lower) - region.x(upper));
            double y = region.y(upper) + share * (region.y(lower) - region.y(upper));
            if (Math.abs(body.floorAt(x, y, low) - high) <= SweptBody.SLACK) {
                on = share;
            } else {
                off = share;
            }
        }
        double x = region.x(upper) + on * (region.x(lower) - region.x(upper));
        double y = region.y(upper) + on * (region.y(lower) - region.y(upper));
        add(points, x, y, high);
    }

    private static void add(List<double[]> points, double x, double y, double z) {
        if (!points.isEmpty()) {
            double[] last = points.get(points.size() - 1);
            if (last[0] == x && last[1] == y && last[2] == z) {
                return;
            }
        }
        points.add(new double[] {x, y, z});
    }

    /** What all cells under a line must have in common. */
    private record Ground(byte kind, double floor, Ability ability) {}

    private boolean isFree(Line line, Ground ground) {
        return passesAlike(line, ground)
                && body.fits(line, ground.floor(), body.radius(ground.ability()))
                && (ground.kind() == Kind.STABLE
                        ? body.rests(line, ground.floor())
                        : body.isSupported(line, ground.floor()));
    }

    /** Walks all cells that the line touches. */
    private boolean passesAlike(Line line, Ground ground) {
        GridFrame frame = region.frame();
        int col = frame.colAt(line.ax());
        int row = frame.rowAt(line.ay());
        int cols = frame.colAt(line.bx()) - col;
        int rows = frame.rowAt(line.by()) - row;
        int right = Integer.signum(cols);
        int up = Integer.signum(rows);
        int colsLeft = Math.abs(cols);
        int rowsLeft = Math.abs(rows);
        double perCol = frame.cell() / Math.abs(line.bx() - line.ax());
        double perRow = frame.cell() / Math.abs(line.by() - line.ay());
        double nextCol = edge(line.ax() - frame.originX(), right) / Math.abs(line.bx() - line.ax());
        double nextRow = edge(line.ay() - frame.originY(), up) / Math.abs(line.by() - line.ay());
        boolean alike = isAlike(col, row, ground);
        while (alike && (colsLeft > 0 || rowsLeft > 0)) {
            boolean corner = colsLeft > 0 && rowsLeft > 0 && Math.abs(nextCol - nextRow) < 1e-9;
            if (corner) {
                alike = isAlike(col + right, row, ground) && isAlike(col, row + up, ground);
            }
            if (corner || rowsLeft == 0 || colsLeft > 0 && nextCol < nextRow) {
                col += right;
                colsLeft--;
                nextCol += perCol;
                if (corner) {
                    row += up;
                    rowsLeft--;
                    nextRow += perRow;
                }
            } else {
                row += up;
                rowsLeft--;
                nextRow += perRow;
            }
            alike = alike && isAlike(col, row, ground);
        }
        return alike;
    }

    /** Returns the metres from an offset to the border of its cell in a direction. */
    private double edge(double offset, int direction) {
        double cell = region.frame().cell();
        double within = offset - Math.floor(offset / cell) * cell;
        return direction > 0 ? cell - within : within;
    }

    private boolean isAlike(int col, int row, Ground ground) {
        Spans spans = region.spans();
        int size = region.frame().size();
        for (int q = region.frame().index(col, row); q < region.spanCount(); q += size) {
            if (spans.exists(q) && spans.floor(q) == ground.floor()) {
                return region.kind(q) == ground.kind()
                        && (region.abilities(q) & ground.ability().bit()) != 0;
            }
        }
        return false;
    }
}
