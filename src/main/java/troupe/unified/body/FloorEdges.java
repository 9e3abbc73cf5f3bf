package troupe.unified.body;

import java.util.Arrays;
import java.util.List;
import troupe.geometry.Box;
import troupe.geometry.Line;
import troupe.geometry.Polygon;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;

/**
 * Knows where the floor changes: the outlines of the immovable obstacles and of the ditches.
 * Whether a disc carried along a line meets a forbidden place is decided exactly: places change only at
 * outlines, so each outline edge near the line is cut where another one meets it, and both sides of every
 * piece that the disc reaches are looked at. Immutable, safe for any thread.
 */
final class FloorEdges {
    /** How far in metres beside an edge its two sides are looked at. */
    private static final double BESIDE = 1e-7;

    private final Polygon[] tops;
    private final double[] elevations;
    private final Polygon[] ditches;
    private final double[] depths;

    /** Says whether a point of the plane may not be under the disc. */
    interface Forbidden {
        boolean at(double x, double y);
    }

    FloorEdges(List<Obstacle> obstacles, List<Ditch> ditches) {
        List<Obstacle> fixed = obstacles.stream().filter(o -> !o.movable()).toList();
        this.tops = fixed.stream().map(Obstacle::outline).toArray(Polygon[]::new);
        this.elevations = fixed.stream().mapToDouble(Obstacle::top).toArray();
        this.ditches = ditches.stream().map(Ditch::outline).toArray(Polygon[]::new);
        this.depths = ditches.stream().mapToDouble(Ditch::depth).toArray();
    }

    /** Returns the elevation of the highest top at a point that is not above {@code reach}. Cost O(obstacles). */
    double floorAt(double x, double y, double reach) {
        double floor = groundAt(x, y);
        for (int i = 0; i < tops.length; i++) {
            if (elevations[i] > floor && elevations[i] <= reach && tops[i].contains(x, y)) {
                floor = elevations[i];
            }
        }
        return floor;
    }

    /** Returns the elevation of the ground at a point: 0, in a ditch below. Cost O(ditches). */
    double groundAt(double x, double y) {
        double ground = 0;
        for (int i = 0; i < ditches.length; i++) {
            if (-depths[i] < ground && ditches[i].contains(x, y)) {
                ground = -depths[i];
            }
        }
        return ground;
    }

    /**
     * Tells whether an open disc of {@code radius}, carried along the line, meets a forbidden point; with a
     * radius of 0 or less, whether the line itself does.
     */
    boolean meets(Line line, double radius, Forbidden forbidden) {
        double reach = Math.max(radius, 0);
        Box box = line.bounds().grown(reach);
        double[] near = edgesNear(box);
        for (int e = 0; e < near.length; e += 4) {
            if (meetsBeside(near, e, box, new Disc(line, reach), forbidden)) {
                return true;
            }
        }
        return forbidden.at(line.ax(), line.ay());
    }

    /** An open disc carried along a line; with radius 0 the line itself. */
    private record Disc(Line line, double radius) {
        boolean reaches(Line edge) {
            double squared = line.distanceSquared(edge.ax(), edge.ay(), edge.bx(), edge.by());
            return radius > 0 ? squared < radius * radius : squared == 0;
        }
    }

    private static boolean meetsBeside(double[] edges, int e, Box box, Disc disc, Forbidden forbidden) {
        Line edge = new Line(edges[e], edges[e + 1], edges[e + 2], edges[e + 3]);
        if (!disc.reaches(edge)) {
            return false;
        }
        double[] cuts = cuts(edges, e, edge, box);
        double length = edge.length();
        double nx = -(edge.by() - edge.ay()) / length * BESIDE;
        double ny = (edge.bx() - edge.ax()) / length * BESIDE;
        for (int i = 1; i < cuts.length; i++) {
            if ((cuts[i] - cuts[i - 1]) * length < SweptBody.SLACK) {
                continue;
            }
            Line piece = part(edge, cuts[i - 1], cuts[i]);
            double mx = (piece.ax() + piece.bx()) / 2;
            double my = (piece.ay() + piece.by()) / 2;
            if (disc.reaches(piece) && (forbidden.at(mx + nx, my + ny) || forbidden.at(mx - nx, my - ny))) {
                return true;
            }
        }
        return false;
    }

    private static Line part(Line edge, double from, double to) {
        double dx = edge.bx() - edge.ax();
        double dy = edge.by() - edge.ay();
        return new Line(edge.ax() + from * dx, edge.ay() + from * dy, edge.ax() + to * dx, edge.ay() + to * dy);
    }

    /** Returns the ordered shares of an edge at which another one or the box's border meets it, and 0 and 1. */
    private static double[] cuts(double[] edges, int e, Line edge, Box box) {
        double[] cuts = new double[6 + edges.length];
        double dx = edge.bx() - edge.ax();
        double dy = edge.by() - edge.ay();
        double squared = dx * dx + dy * dy;
        cuts[1] = 1;
        int count = 2;
        if (dx != 0) {
            count = add(cuts, count, (box.minX() - edge.ax()) / dx);
            count = add(cuts, count, (box.maxX() - edge.ax()) / dx);
        }
        if (dy != 0) {
            count = add(cuts, count, (box.minY() - edge.ay()) / dy);
            count = add(cuts, count, (box.maxY() - edge.ay()) / dy);
        }
        for (int k = 0; k < edges.length; k += 4) {
            if (k == e) {
                continue;
            }
            double ex = edges[k + 2] - edges[k];
            double ey = edges[k + 3] - edges[k + 1];
            double cross = dx * ey - dy * ex;
            double ox = edges[k] - edge.ax();
            double oy = edges[k + 1] - edge.ay();
            if (Math.abs(cross) > 1e-12 * squared) {
                count = add(cuts, count, (ox * ey - oy * ex) / cross);
            } else {
                count = add(cuts, count, (ox * dx + oy * dy) / squared);
                count = add(cuts, count, ((ox + ex) * dx + (oy + ey) * dy) / squared);
            }
        }
        double[] found = Arrays.copyOf(cuts, count);
        Arrays.sort(found);
        return found;
    }

    private static int add(double[] cuts, int count, double share) {
        if (share > 0 && share < 1) {
            cuts[count] = share;
            return count + 1;
        }
        return count;
    }

    /** Returns the outline edges whose box meets the given one, as {@code ax, ay, bx, by} in turn. */
    private double[] edgesNear(Box box) {
        double[] found = new double[64];
        int count = 0;
        for (Polygon[] outlines : List.of(tops, ditches)) {
            for (Polygon p : outlines) {
                if (!p.bounds().meets(box)) {
                    continue;
                }
                for (int i = 0, j = p.size() - 1; i < p.size(); j = i++) {
                    if (Math.min(p.x(i), p.x(j)) > box.maxX()
                            || Math.max(p.x(i), p.x(j)) < box.minX()
                            || Math.min(p.y(i), p.y(j)) > box.maxY()
                            || Math.max(p.y(i), p.y(j)) < box.minY()
                            || p.x(i) == p.x(j) && p.y(i) == p.y(j)) {
                        continue;
                    }
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count);
                    }
                    found[count++] = p.x(j);
                    found[count++] = p.y(j);
                    found[count++] = p.x(i);
                    found[count++] = p.y(i);
                }
            }
        }
        return Arrays.copyOf(found, count);
    }
}
