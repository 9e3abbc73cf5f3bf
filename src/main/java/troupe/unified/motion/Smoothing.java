package troupe.unified.motion;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Line;
import troupe.geometry.Point;
import troupe.grid.GridFrame;
import troupe.grid.layer.Spans;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.unified.body.SweptBody;

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
    /** Trials along a step for the place where the feet change floors. */
    private static final int CHANGES = 8;

    private final Region region;
    private final SweptBody body;

    Smoothing(Region region, SweptBody body) {
        this.region = region;
        this.body = body;
    }

    /**
     * Returns the smoothed line, {@code x, y, z} in metres, of a part of a path that is travelled with one
     * ability on spans; it keeps both ends. Where the floor changes the feet keep to the higher floor all
     * along the step and rise, or sink, within {@link #SLOPE} metres before, or after it; where head room
     * forbids that they change floors farther up the step.
     *
     * @param path configurations of spans, each a neighbour of the one before
     */
    List<double[]> smoothed(int[] path, Ability ability) {
        List<double[]> points = new ArrayList<>();
        int begin = 0;
        double before = region.elevation(path[0]);
        for (int i = 1; i <= path.length; i++) {
            if (i < path.length && isAlike(path[begin], path[i])) {
                continue;
            }
            double floor = region.elevation(path[begin]);
            double after = i == path.length ? floor : region.elevation(path[i]);
            double share = floor == after ? 0 : change(path[i - 1], path[i], ability);
            List<Point> line = taut(path, begin, i, ability);
            addLevel(points, line, new Level(floor, before, share == 0 ? after : floor));
            if (share > 0) {
                Point at = between(path[i - 1], path[i], floor < after ? share : 1 - share);
                add(points, at, floor);
                add(points, at, after);
            }
            before = share == 0 ? floor : after;
            begin = i;
        }
        settle(points, 0, region.elevation(path[0]));
        settle(points, points.size() - 1, region.elevation(path[path.length - 1]));
        return points;
    }

    /** Returns the share of a step, from its lower end, at which the feet change floors: the least that leaves room. */
    private double change(int from, int to, Ability ability) {
        boolean rises = region.elevation(from) < region.elevation(to);
        int lower = rises ? from : to;
        int upper = rises ? to : from;
        double radius = body.radius(ability);
        double step = between(lower, upper, 0).distance(between(lower, upper, 1));
        double least = Math.sqrt(Math.max(0, radius * radius - step * step / 4));
        for (int k = 0; k <= CHANGES; k++) {
            double share = k / (double) CHANGES;
            Point at = between(lower, upper, share);
            if (body.fits(line(between(lower, upper, 0), at), region.elevation(lower), least)
                    && body.fits(line(at, between(lower, upper, 1)), region.elevation(upper), least)) {
                return share;
            }
        }
        return 0;
    }

    private Point between(int from, int to, double share) {
        return new Point(
                region.x(from) + share * (region.x(to) - region.x(from)),
                region.y(from) + share * (region.y(to) - region.y(from)));
    }

    private static Line line(Point a, Point b) {
        return new Line(a.x(), a.y(), b.x(), b.y());
    }

    /** Puts the feet down at an end from which there was no room for a slope. */
    private static void settle(List<double[]> points, int end, double floor) {
        double[] at = points.get(end);
        if (at[2] != floor) {
            points.add(end == 0 ? 0 : end + 1, new double[] {at[0], at[1], floor});
        }
    }

    /** A floor, and the floors before and after it. */
    private record Level(double floor, double before, double after) {

        /** Returns the elevation at which the feet come in. */
        double entry() {
            return Math.max(floor, before);
        }

        /** Returns the elevation at which they go out. */
        double exit() {
            return Math.max(floor, after);
        }
    }

    /** Adds a line on one floor, with slopes to where it is entered and left at other elevations. */
    private static void addLevel(List<double[]> points, List<Point> line, Level level) {
        int last = line.size() - 1;
        if (last == 0) {
            addSingle(points, line.get(0), level);
            return;
        }
        add(points, line.get(0), level.entry());
        if (level.entry() > level.floor()) {
            add(points, beside(line.get(0), line.get(1), last == 1), level.floor());
        }
        for (Point p : line.subList(1, last)) {
            add(points, p, level.floor());
        }
        if (level.exit() > level.floor()) {
            add(points, beside(line.get(last), line.get(last - 1), last == 1), level.floor());
        }
        add(points, line.get(last), level.exit());
    }

    /** Adds a single place: the slope lies on the step at whose both ends the floor is the same, if there is one. */
    private static void addSingle(List<double[]> points, Point p, Level level) {
        boolean changes = level.before() != level.floor() && level.after() != level.floor();
        if (changes && level.entry() != level.exit()) {
            add(points, p, level.entry());
            add(points, p, level.exit());
        } else {
            add(points, p, Math.max(level.entry(), level.exit()));
        }
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
