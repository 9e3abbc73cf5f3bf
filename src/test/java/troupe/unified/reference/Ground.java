package troupe.unified.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Works out what cannot be moved: the floors over every cell, what is under the foot there, and which bodies
 * have room. A configuration has the same number in every search space: spans come first, sheet by sheet, then a
 * place for each crossing that there might be, by cell, take-off floor and kind (gap before vault).
 */
final class Ground {
    static final int WALK = 1;
    static final int SIDESTEP = 2;
    static final int CROSS = 4;
    static final int ABSENT = 0;
    static final int STABLE = 1;
    static final int BORDER = 2;
    static final int DROP = 3;
    static final double SAME = 1e-9;
    private static final double BESIDE = 1e-7;

    final Scene scene;
    final Actor actor;
    final double cell;
    final int cols;
    final int cells;
    final int spanCount;
    final int size;
    final double[] levels;
    final double[] floor;
    final double[] ceiling;
    final int[] levelOf;
    final int[] kind;
    final int[] room;
    private final List<Piece> pieces = new ArrayList<>();

    /** A stretch of an outline with the same things to its left, and the same to its right, all along. */
    private record Piece(double[] segment, double[] left, double[] right) {}

    private final Map<Integer, int[]> between = new TreeMap<>();
    private final Map<Double, List<int[]>> within = new TreeMap<>();
    private final Map<Integer, TreeSet<Double>> groundsNear = new TreeMap<>();
    private final byte[][] fixedNear;

    private record Solid(double bottom, double top) {}

    Ground(Scene scene, Actor actor) {
        this.scene = scene;
        this.actor = actor;
        cell = scene.world().cell();
        cols = (int) Math.ceil(scene.world().width() / cell - 1e-9) + 2;
        cells = cols * ((int) Math.ceil(scene.world().depth() / cell - 1e-9) + 2);
        fixedNear = new byte[scene.obstacles().size()][cells];
        List<List<double[]>> spans = new ArrayList<>();
        TreeSet<Double> floors = new TreeSet<>();
        int sheets = 1;
        for (int at = 0; at < cells; at++) {
            spans.add(spans(x(at), y(at)));
            sheets = Math.max(sheets, spans.get(at).size());
            spans.get(at).forEach(span -> floors.add(span[0]));
        }
        levels = distinct(floors);
        spanCount = sheets * cells;
        size = spanCount + cells * levels.length * 2;
        floor = new double[spanCount];
        ceiling = new double[spanCount];
        levelOf = new int[spanCount];
        kind = new int[spanCount];
        room = new int[spanCount];
        cutPieces();
        for (int q = 0; q < spanCount; q++) {
            if (q / cells < spans.get(q % cells).size()) {
                double[] span = spans.get(q % cells).get(q / cells);
                floor[q] = span[0];
                ceiling[q] = span[1];
                levelOf[q] = level(span[0]);
                kind[q] = underFoot(x(q % cells), y(q % cells), span[0]);
                room[q] = kind[q] == DROP ? 0 : bodies(q);
            }
        }
    }

    private static double[] distinct(TreeSet<Double> floors) {
        List<Double> kept = new ArrayList<>();
        for (double f : floors) {
            if (kept.isEmpty() || f - kept.get(kept.size() - 1) > SAME) {
                kept.add(f);
            }
        }
        return kept.stream().mapToDouble(f -> f).toArray();
    }

    /** Returns the number of a floor's elevation among {@link #levels}. */
    int level(double elevation) {
        int level = 0;
        while (Math.abs(levels[level] - elevation) > SAME) {
            level++;
        }
        return level;
    }

    double x(int at) {
        return (at % cols - 0.5) * cell;
    }

    double y(int at) {
        return (at / cols - 0.5) * cell;
    }

    /** Returns the cell that holds a place in the world, or its border. */
    int cellAt(double x, double y) {
        return ((int) Math.floor(y / cell) + 1) * cols + (int) Math.floor(x / cell) + 1;
    }

    /** Returns the cell over which a configuration lies. */
    int cellOf(int q) {
        return q < spanCount ? q % cells : (q - spanCount) / (2 * levels.length);
    }

    /** Returns the floor of a span, or the take-off floor of a crossing. */
    double elevation(int q) {
        return q < spanCount ? floor[q] : levels[(q - spanCount) / 2 % levels.length];
    }

    int crossing(int at, int level, boolean vault) {
        return spanCount + (at * levels.length + level) * 2 + (vault ? 1 : 0);
    }

    boolean isVault(int q) {
        return (q - spanCount) % 2 == 1;
    }

    boolean outside(double x, double y) {
        return x < 0
                || y < 0
                || x >= scene.world().width()
                || y >= scene.world().depth();
    }

    double edge(double x, double y) {
        return Math.min(
                Math.min(x, scene.world().width() - x),
                Math.min(y, scene.world().depth() - y));
    }

    /** Returns the cell so many columns and rows from another one, -1 outside the frame. */
    int shifted(int at, int[] step) {
        int col = at % cols + step[0];
        int row = at / cols + step[1];
        return col < 0 || row < 0 || col >= cols || row >= cells / cols ? -1 : row * cols + col;
    }

    /** Returns the column and row steps to the cells within a distance in metres. */
    List<int[]> within(double metres) {
        return within.computeIfAbsent(metres, m -> Discs.within(this, m));
    }

    /** Returns the cells that the segment between two centres runs through, the ends excepted. */
    int[] between(int from, int to) {
        int dx = to % cols - from % cols;
        int dy = to / cols - from / cols;
        int[] steps = between.computeIfAbsent(dy * 10_000 + dx, k -> Discs.between(dx, dy).stream()
                .mapToInt(s -> s[1] * cols + s[0])
                .toArray());
        int[] passed = new int[steps.length];
        for (int i = 0; i < steps.length; i++) {
            passed[i] = from + steps[i];
        }
        return passed;
    }

    /** Tells whether an obstacle that cannot be moved comes within the walk radius of a cell's centre. */
    boolean fixedNear(int n, int at) {
        if (fixedNear[n][at] == 0) {
            boolean near =
                    near(scene.obstacles().get(n).outline(), at, actor.walk().radius());
            fixedNear[n][at] = (byte) (near ? 1 : 2);
        }
        return fixedNear[n][at] == 1;
    }

    /** Returns the elevations of the bare ground within the walk radius of a cell's centre. */
    TreeSet<Double> groundsWithinWalk(int at) {
        return groundsNear.computeIfAbsent(at, k -> groundsNear(k, actor.walk().radius()));
    }

    double groundAt(double x, double y) {
        double ground = 0;
        for (Ditch ditch : scene.ditches()) {
            ground = Shapes.inside(ditch.outline(), x, y) ? Math.min(ground, -ditch.depth()) : ground;
        }
        return ground;
    }

    /** Returns what fills the space over a point, the ground first; solids less than 1 mm apart are one. */
    private List<Solid> column(double x, double y) {
        List<Solid> all = new ArrayList<>();
        all.add(new Solid(Double.NEGATIVE_INFINITY, groundAt(x, y)));
        for (Obstacle o : scene.obstacles()) {
            if (!o.movable() && Shapes.inside(o.outline(), x, y)) {
                all.add(new Solid(o.offset(), o.top()));
            }
        }
        all.sort(Comparator.comparingDouble(Solid::bottom).thenComparingDouble(Solid::top));
        List<Solid> merged = new ArrayList<>();
        for (Solid s : all) {
            Solid last = merged.isEmpty() ? null : merged.get(merged.size() - 1);
            if (last != null && s.bottom() < last.top() + 1e-3) {
                merged.set(merged.size() - 1, new Solid(last.bottom(), Math.max(last.top(), s.top())));
            } else {
                merged.add(s);
            }
        }
        return merged;
    }

    private List<double[]> spans(double x, double y) {
        double body = actor.vault()
                .map(v -> Math.min(v.bodyHeight(), actor.bodyHeight()))
                .orElse(actor.bodyHeight());
        List<double[]> spans = new ArrayList<>();
        List<Solid> solids = outside(x, y) ? List.of() : column(x, y);
        for (int i = 0; i < solids.size(); i++) {
            double above = i + 1 < solids.size() ? solids.get(i + 1).bottom() : Double.POSITIVE_INFINITY;
            if (above - solids.get(i).top() >= body - SAME) {
                spans.add(new double[] {solids.get(i).top(), above});
            }
        }
        return spans;
    }

    static boolean meets(double bottom, double top, double low, double high) {
        return bottom < high - SAME && top > low + SAME;
    }

    /** Tells whether an obstacle is in the way of a body on a floor; a movable one is from the floor itself. */
    boolean inWay(Obstacle o, double on) {
        return meets(o.offset(), o.top(), on + (o.movable() ? 0 : actor.stepHeight()), on + actor.bodyHeight());
    }

    boolean touching(double radius) {
        return radius < 0.71 * cell;
    }

    /** Tells whether an outline comes nearer to a cell's centre than a radius, or through the cell if that is small. */
    boolean near(Polygon outline, int at, double radius) {
        return Shapes.distance(outline, x(at), y(at)) < radius
                || touching(radius) && Shapes.touches(outline, x(at), y(at), cell / 2);
    }

    boolean nearEdge(int at, double radius) {
        double edge = edge(x(at), y(at));
        Polygon world =
                Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth());
        return edge <= 0 || edge < radius || touching(radius) && Shapes.touches(world, x(at), y(at), cell / 2);
    }

    /** Tells whether ground higher than a limit comes nearer to a cell's centre than a radius. */
    boolean nearGround(int at, double limit, double radius) {
        return groundsNear(at, radius).last() > limit;
    }

    /** Returns the elevations of the bare ground within a radius of a cell's centre. */
    TreeSet<Double> groundsNear(int at, double radius) {
        TreeSet<Double> grounds = new TreeSet<>(List.of(groundAt(x(at), y(at))));
        if (scene.ditches().isEmpty()) {
            return grounds;
        }
        for (Piece p : pieces) {
            double[] s = p.segment;
            double left = outside(p.left[0], p.left[1]) ? Double.NaN : groundAt(p.left[0], p.left[1]);
            double right = outside(p.right[0], p.right[1]) ? Double.NaN : groundAt(p.right[0], p.right[1]);
            boolean near = left != right
                    && (Shapes.distance(x(at), y(at), s[0], s[1], s[2], s[3]) < radius
                            || touching(radius) && Shapes.touches(s, x(at), y(at), cell / 2));
            for (double ground : near ? new double[] {left, right} : new double[0]) {
                if (!Double.isNaN(ground)) {
                    grounds.add(ground);
                }
            }
        }
        return grounds;
    }

    /** Returns the least distance from a segment to ground above a limit. */
    double distanceToGround(double[] segment, double limit) {
        if (limit >= 0 || scene.ditches().isEmpty()) {
            return limit >= 0 ? Double.POSITIVE_INFINITY : 0;
        }
        double least = groundAt(segment[0], segment[1]) > limit ? 0 : Double.POSITIVE_INFINITY;
        for (Piece p : pieces) {
            double left = groundAt(p.left[0], p.left[1]);
            double right = groundAt(p.right[0], p.right[1]);
            if (Math.max(left, right) > limit) {
                least = Math.min(least, Shapes.distance(segment, p.segment));
            }
        }
        return least;
    }

    private int bodies(int q) {
        double high = floor[q] + actor.bodyHeight();
        if (ceiling[q] < high - SAME) {
            return 0;
        }
        double sidestep = actor.sidestep().map(Actor.Sidestep::radius).orElse(Double.NaN);
        return (fits(q, actor.walk().radius()) ? WALK : 0)
                | (!Double.isNaN(sidestep) && fits(q, sidestep) ? SIDESTEP : 0);
    }

    private boolean fits(int q, double radius) {
        int at = q % cells;
        boolean free = !nearEdge(at, radius) && !nearGround(at, floor[q] + actor.stepHeight() + SAME, radius);
        for (Obstacle o : scene.obstacles()) {
            free = free && (o.movable() || !inWay(o, floor[q]) || !near(o.outline(), at, radius));
        }
        return free;
    }

    /** Returns the floor for a foot at a point; NaN outside, and where something is in the way of a body there. */
    private double under(double[] point, double on) {
        if (outside(point[0], point[1])) {
            return Double.NaN;
        }
        double highest = Double.NEGATIVE_INFINITY;
        for (Solid s : column(point[0], point[1])) {
            if (meets(s.bottom(), s.top(), on + actor.stepHeight(), on + actor.bodyHeight())) {
                return Double.NaN;
            }
            highest = s.top() <= on + actor.stepHeight() + SAME ? s.top() : highest;
        }
        return highest;
    }

    private int underFoot(double x, double y, double on) {
        int worst = STABLE;
        for (Piece p : pieces) {
            double[] s = p.segment;
            if (Shapes.distance(x, y, s[0], s[1], s[2], s[3]) >= actor.footRadius()) {
                continue;
            }
            for (double[] beside : List.of(p.left, p.right)) {
                double under = under(beside, on);
                if (under < on - actor.stepHeight() - SAME) {
                    worst = DROP;
                } else if (Math.abs(under - on) > SAME) {
                    worst = Math.max(worst, BORDER);
                }
            }
        }
        return worst;
    }

    /** Cuts every outline of what cannot be moved wherever another one, or the world's edge, crosses its line. */
    private void cutPieces() {
        List<Polygon> outlines = new ArrayList<>();
        scene.ditches().forEach(d -> outlines.add(d.outline()));
        scene.obstacles().stream().filter(o -> !o.movable()).forEach(o -> outlines.add(o.outline()));
        List<double[]> edges = new ArrayList<>();
        outlines.forEach(p -> edges.addAll(edges(p)));
        List<double[]> lines = new ArrayList<>(edges);
        lines.addAll(edges(
                Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth())));
        for (double[] e : edges) {
            TreeSet<Double> cuts = new TreeSet<>(List.of(0.0, 1.0));
            for (double[] line : lines) {
                cuts.addAll(cuts(e, line));
            }
            double from = 0;
            for (double to : cuts) {
                double dx = e[2] - e[0];
                double dy = e[3] - e[1];
                double length = Math.hypot(dx, dy);
                if ((to - from) * length > 1e-8) {
                    double x = e[0] + (from + to) / 2 * dx;
                    double y = e[1] + (from + to) / 2 * dy;
                    double nx = -dy / length * BESIDE;
                    double ny = dx / length * BESIDE;
                    pieces.add(new Piece(
                            new double[] {e[0] + from * dx, e[1] + from * dy, e[0] + to * dx, e[1] + to * dy},
                            new double[] {x + nx, y + ny},
                            new double[] {x - nx, y - ny}));
                }
                from = to;
            }
        }
    }

    private static List<double[]> edges(Polygon p) {
        List<double[]> edges = new ArrayList<>();
        for (int i = 0; i < p.size(); i++) {
            int j = (i + 1) % p.size();
            edges.add(new double[] {p.x(i), p.y(i), p.x(j), p.y(j)});
        }
        return edges;
    }

    /** Returns the shares of an edge at which another one crosses it, or an end of that lies on it. */
    private static List<Double> cuts(double[] e, double[] other) {
        double dx = e[2] - e[0];
        double dy = e[3] - e[1];
        double ox = other[2] - other[0];
        double oy = other[3] - other[1];
        double cross = dx * oy - dy * ox;
        double squared = dx * dx + dy * dy;
        List<Double> cuts = new ArrayList<>();
        if (Math.abs(cross) > 1e-12) {
            double share = ((other[0] - e[0]) * dy - (other[1] - e[1]) * dx) / cross;
            if (share > -1e-7 && share < 1 + 1e-7) {
                cuts.add(((other[0] - e[0]) * oy - (other[1] - e[1]) * ox) / cross);
            }
        }
        for (int end = 0; end < 4; end += 2) {
            if (Shapes.distance(other[end], other[end + 1], e[0], e[1], e[2], e[3]) < 1e-7) {
                cuts.add(((other[end] - e[0]) * dx + (other[end + 1] - e[1]) * dy) / squared);
            }
        }
        cuts.removeIf(t -> !(t > 0 && t < 1));
        return cuts;
    }
}
