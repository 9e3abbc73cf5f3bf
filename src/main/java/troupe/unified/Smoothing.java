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
    /** Length in metres of the slope from one floor to the next. */
    private static final double SLOPE = 0.15;

    private final Region region;
    private final SweptBody body;

    Smoothing(Region region, SweptBody body) {
        this.region = region;
        this.body = body;
    }

    /**
     * Returns the smoothed line, {@code x, y, z} in metres, of a part of a path that is travelled with one
     * ability on spans; it keeps both ends. Where the floor changes the feet keep to the higher floor all
     * along the step and rise, or sink, within {@link #SLOPE} metres before, or after it.
     *
     * @param path configurations of spans, each a neighbour of the one before
     */
    List<double[]> smoothed(int[] path, Ability ability) {
        List<double[]> points = new ArrayList<>();
        int begin = 0;
        for (int i = 1; i <= path.length; i++) {
            if (i == path.length || !isAlike(path[begin], path[i])) {
                double floor = region.elevation(path[begin]);
                double entry = begin == 0 ? floor : Math.max(floor, region.elevation(path[begin - 1]));
                double exit = i == path.length ? floor : Math.max(floor, region.elevation(path[i]));
                addLevel(points, taut(path, begin, i, ability), floor, entry, exit);
                begin = i;
            }
        }
        settle(points, 0, region.elevation(path[0]));
        settle(points, points.size() - 1, region.elevation(path[path.length - 1]));
        return points;
    }

    /** Puts the feet down at an end from which there was no room for a slope. */
    private static void settle(List<double[]> points, int end, double floor) {
        double[] at = points.get(end);
        if (at[2] != floor) {
            points.add(end == 0 ? 0 : end + 1, new double[] {at[0], at[1], floor});
        }
    }

    /** Adds a line on one floor whose ends lie at other heights, with slopes to them. */
    private static void addLevel(List<double[]> points, List<Point> line, double floor, double entry, double exit) {
        int last = line.size() - 1;
        if (last == 0) {
            add(points, line.get(0), Math.max(entry, exit));
            return;
        }
        add(points, line.get(0), entry);
        if (entry > floor) {
            add(points, beside(line.get(0), line.get(1), last == 1), floor);
        }
        for (Point p : line.subList(1, last)) {
            add(points, p, floor);
        }
        if (exit > floor) {
            add(points, beside(line.get(last), line.get(last - 1), last == 1), floor);
        }
        add(points, line.get(last), exit);
    }

    /** Returns the point where a slope that begins at a point ends on the way to another one. */
    private static Point beside(Point from, Point to, boolean shared) {
        double length = from.distance(to);
        double share = Math.min(SLOPE, shared ? length / 2 : length) / length;
        return new Point(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
    }

    private static void add(List<double[]> points, Point p, double z) {
        points.add(new double[] {p.x(), p.y(), z});
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
