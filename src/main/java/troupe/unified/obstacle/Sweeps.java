package troupe.unified.obstacle;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.geometry.Arcs;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.grid.GridFrame;
import troupe.scene.World;

/**
 * Tells which moves of an obstacle have room: translations by a cell or its diagonal and turns by one
 * heading, from the pose chosen last. Exact on the polygons: the outline, drawn in by 1e-9 m so that sliding
 * along another is no contact, may not touch another outline nor the world's edge on its way. Two outlines
 * that are apart first touch where a corner of one meets an edge of the other, so each corner's way is held
 * against the other's edges: straight lines in a translation, arcs in a turn.
 *
 * <p>At each pose the distance to what is near is measured once; moves that carry no point so far need no
 * more. Used by one thread at a time; nothing is allocated once the neighbourhood is known.
 */
public final class Sweeps {
    private static final double MARGIN = 1e-6;

    private final Movable movable;
    private final NearEdges edges;
    private final double[] dx = new double[GridFrame.DIRECTIONS];
    private final double[] dy = new double[GridFrame.DIRECTIONS];
    private final double chord;
    private final double reach;
    private final double cos;
    private final double sin;
    private final boolean wide;
    private final boolean free;

    private double cx;
    private double cy;
    private Polygon shape;
    private final double[] px;
    private final double[] py;
    private int[] near = new int[16];
    private int count;
    private double squared;
    private double minX;
    private double minY;
    private double maxX;
    private double maxY;

    /** Makes the moves of an obstacle among outlines that it must not run into. */
    Sweeps(Movable movable, World world, List<Polygon> barriers) {
        this.movable = movable;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            dx[d] = GridFrame.dx(d) * movable.cell();
            dy[d] = GridFrame.dy(d) * movable.cell();
        }
        double turn = movable.turn();
        chord = 2 * movable.farthest() * StrictMath.sin(Math.min(turn, Math.PI) / 2);
        cos = StrictMath.cos(turn);
        sin = StrictMath.sin(turn);
        wide = turn > Math.PI;
        reach = Math.max(movable.cell() * Math.sqrt(2), chord) + MARGIN;
        List<Polygon> outlines = new ArrayList<>(barriers);
        outlines.add(Polygon.rectangle(0, 0, world.width(), world.depth()));
        edges = new NearEdges(world, outlines, movable.farthest() + reach);
        px = new double[movable.inset(0).size()];
        py = new double[px.length];
        free = isFree(world, barriers);
    }

    /** Tells whether the obstacle, where it stands, overlaps nothing by more than the tolerance. */
    private boolean isFree(World world, List<Polygon> barriers) {
        choose(0, 0, 0);
        for (int v = 0; v < px.length; v++) {
            px[v] = cx + shape.x(v);
            py[v] = cy + shape.y(v);
            if (!(px[v] > 0 && py[v] > 0 && px[v] < world.width() && py[v] < world.depth())) {
                return false;
            }
        }
        for (int n = 0; n < count; n++) {
            int e = near[n];
            for (int v = 0, u = px.length - 1; v < px.length; u = v++) {
                if (Segments.meet(px[u], py[u], px[v], py[v], edges.ax(e), edges.ay(e), edges.bx(e), edges.by(e))) {
                    return false;
                }
            }
        }
        Polygon inset = new Polygon(px, py);
        for (Polygon other : barriers) {
            if (other.contains(px[0], py[0]) || inset.contains(other.x(0), other.y(0))) {
                return false;
            }
        }
        return true;
    }

    /** Tells whether the obstacle can be moved at all: not if it overlaps another where it stands. */
    public boolean isFree() {
        return free;
    }

    /** Chooses the pose from which moves are asked for. */
    public void choose(int i, int j, int k) {
        cx = movable.centroid().x() + i * movable.cell();
        cy = movable.centroid().y() + j * movable.cell();
        shape = movable.inset(k);
        count = 0;
        squared = Double.NaN;
        int[] candidates = edges.near(cx, cy);
        if (candidates.length == 0) {
            return;
        }
        minX = cx + shape.bounds().minX();
        minY = cy + shape.bounds().minY();
        maxX = cx + shape.bounds().maxX();
        maxY = cy + shape.bounds().maxY();
        for (int e : candidates) {
            if (edges.meetsBox(e, minX - reach, minY - reach, maxX + reach, maxY + reach)) {
                if (count == near.length) {
                    near = Arrays.copyOf(near, 2 * count);
                }
                near[count++] = e;
            }
        }
        if (count > 0) {
            for (int v = 0; v < px.length; v++) {
                px[v] = cx + shape.x(v);
                py[v] = cy + shape.y(v);
            }
        }
    }

    /** Tells whether the move by one cell in a direction of {@link GridFrame} has room. */
    public boolean canShift(int direction) {
        if (count == 0) {
            return true;
        }
        double mx = dx[direction];
        double my = dy[direction];
        if (mx * mx + my * my < distanceSquared()) {
            return true;
        }
        double lowX = Math.min(minX, minX + mx);
        double lowY = Math.min(minY, minY + my);
        double highX = Math.max(maxX, maxX + mx);
        double highY = Math.max(maxY, maxY + my);
        for (int n = 0; n < count; n++) {
            int e = near[n];
            if (edges.meetsBox(e, lowX, lowY, highX, highY) && meetsShifted(e, mx, my)) {
                return false;
            }
        }
        return true;
    }

    private boolean meetsShifted(int e, double mx, double my) {
        double ax = edges.ax(e);
        double ay = edges.ay(e);
        double bx = edges.bx(e);
        double by = edges.by(e);
        for (int v = 0, u = px.length - 1; v < px.length; u = v++) {
            if (Segments.meet(px[v], py[v], px[v] + mx, py[v] + my, ax, ay, bx, by)
                    || Segments.meet(ax, ay, ax - mx, ay - my, px[u], py[u], px[v], py[v])) {
                return true;
            }
        }
        return false;
    }

    /** Tells whether the turn by one heading, counter-clockwise or clockwise, has room. */
    public boolean canTurn(boolean counterClockwise) {
        if (count == 0 || chord * chord < distanceSquared()) {
            return true;
        }
        for (int n = 0; n < count; n++) {
            int e = near[n];
            if (edges.meetsBox(e, minX - chord, minY - chord, maxX + chord, maxY + chord)
                    && meetsTurned(e, counterClockwise)) {
                return false;
            }
        }
        return true;
    }

    /** A corner turns with the obstacle; to the obstacle, a corner of the others turns the other way. */
    private boolean meetsTurned(int e, boolean counterClockwise) {
        double ax = edges.ax(e) - cx;
        double ay = edges.ay(e) - cy;
        double bx = edges.bx(e) - cx;
        double by = edges.by(e) - cy;
        for (int v = 0, u = px.length - 1; v < px.length; u = v++) {
            double vx = shape.x(v);
            double vy = shape.y(v);
            if (meetsArc(vx, vy, counterClockwise, ax, ay, bx, by)
                    || meetsArc(ax, ay, !counterClockwise, shape.x(u), shape.y(u), vx, vy)) {
                return true;
            }
        }
        return false;
    }

    private boolean meetsArc(double x, double y, boolean counterClockwise, double ax, double ay, double bx, double by) {
        if (counterClockwise) {
            return Arcs.meet(x, y, cos * x - sin * y, sin * x + cos * y, wide, ax, ay, bx, by);
        }
        return Arcs.meet(cos * x + sin * y, cos * y - sin * x, x, y, wide, ax, ay, bx, by);
    }

    /** Returns the squared distance to the nearest of the near edges, measured once for each pose. */
    private double distanceSquared() {
        if (Double.isNaN(squared)) {
            double least = Double.POSITIVE_INFINITY;
            for (int n = 0; n < count && least > 0; n++) {
                int e = near[n];
                for (int v = 0, u = px.length - 1; v < px.length; u = v++) {
                    double a =
                            Segments.distanceSquared(px[v], py[v], edges.ax(e), edges.ay(e), edges.bx(e), edges.by(e));
                    double b = Segments.distanceSquared(edges.ax(e), edges.ay(e), px[u], py[u], px[v], py[v]);
                    least = Math.min(least, Math.min(a, b));
                }
            }
            squared = least * (1 - MARGIN);
        }
        return squared;
    }
}
