package troupe.exchange.track;

import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.geometry.Polygon;

/** Holds a closed outline that does not touch itself: corners on a grid of micrometres, in metres, none twice. */
final class Ring {
    private static final double MICRO = 1e6;
    /** Smaller rings, in square metres, are slivers of rounding. */
    private static final double LEAST_AREA = 1e-6;

    private final List<double[]> corners;
    private final Polygon polygon;

    private Ring(List<double[]> corners) {
        this.corners = corners;
        this.polygon = new Polygon(
                corners.stream().mapToDouble(c -> c[0]).toArray(),
                corners.stream().mapToDouble(c -> c[1]).toArray());
    }

    /** Returns the rings that bound an area; where the boundary touches itself in a corner it is parted there. */
    static List<Ring> of(Area area) {
        List<Ring> rings = new ArrayList<>();
        List<double[]> corners = new ArrayList<>();
        double[] at = new double[6];
        for (PathIterator path = area.getPathIterator(null); !path.isDone(); path.next()) {
            switch (path.currentSegment(at)) {
                case PathIterator.SEG_CLOSE -> {
                    part(corners, rings);
                    corners = new ArrayList<>();
                }
                case PathIterator.SEG_MOVETO, PathIterator.SEG_LINETO ->
                    corners.add(new double[] {Math.rint(at[0] * MICRO) / MICRO, Math.rint(at[1] * MICRO) / MICRO});
                default -> throw new IllegalStateException("an area of polygons has no curves");
            }
        }
        return rings;
    }

    /** Cuts a closed walk at the corners that it visits twice; each loop is a ring. Cost O(corners²). */
    private static void part(List<double[]> walk, List<Ring> rings) {
        List<double[]> open = new ArrayList<>();
        for (double[] corner : walk) {
            int before = open.size() - 1;
            while (before >= 0 && !Arrays.equals(open.get(before), corner)) {
                before--;
            }
            if (before >= 0) {
                keep(new ArrayList<>(open.subList(before, open.size())), rings);
                open.subList(before + 1, open.size()).clear();
            } else {
                open.add(corner);
            }
        }
        keep(open, rings);
    }

    private static void keep(List<double[]> loop, List<Ring> rings) {
        if (loop.size() >= 3) {
            Ring ring = new Ring(loop);
            if (Math.abs(ring.signedArea()) > LEAST_AREA) {
                rings.add(ring);
            }
        }
    }

    /** Returns the area of a polygon by the even-odd rule. */
    static Area area(Polygon polygon) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        path.moveTo(polygon.x(0), polygon.y(0));
        for (int i = 1; i < polygon.size(); i++) {
            path.lineTo(polygon.x(i), polygon.y(i));
        }
        path.closePath();
        return new Area(path);
    }

    double signedArea() {
        return polygon.signedArea();
    }

    boolean contains(double x, double y) {
        return polygon.contains(x, y);
    }

    /** Tells whether another ring, which does not cross this one, lies inside. */
    boolean holds(Ring other) {
        // a larger ring is never inside, though a point inside of it may well be
        if (Math.abs(signedArea()) <= Math.abs(other.signedArea())) {
            return false;
        }
        double[] inside = other.inside();
        return contains(inside[0], inside[1]);
    }

    /** Returns a point inside: half-way along the widest cut at a height between two corners. */
    private double[] inside() {
        double[] ys =
                corners.stream().mapToDouble(c -> c[1]).distinct().sorted().toArray();
        double[] best = corners.get(0);
        double widest = 0;
        for (int i = 0; i + 1 < ys.length; i++) {
            double y = (ys[i] + ys[i + 1]) / 2;
            double[] cuts = cuts(y);
            for (int k = 0; k + 1 < cuts.length; k += 2) {
                double width = Math.min(cuts[k + 1] - cuts[k], ys[i + 1] - ys[i]);
                if (width > widest) {
                    widest = width;
                    best = new double[] {(cuts[k] + cuts[k + 1]) / 2, y};
                }
            }
        }
        return best;
    }

    private double[] cuts(double y) {
        List<Double> cuts = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            double[] a = corners.get(i);
            double[] b = corners.get((i + 1) % corners.size());
            if (a[1] < y != b[1] < y) {
                cuts.add(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
            }
        }
        return cuts.stream().mapToDouble(Double::doubleValue).sorted().toArray();
    }

    /** Returns the polygon, counter-clockwise or clockwise. */
    Polygon turned(boolean counterClockwise) {
        if (signedArea() > 0 == counterClockwise) {
            return polygon;
        }
        int n = corners.size();
        double[] xs = new double[n];
        double[] ys = new double[n];
        for (int i = 0; i < n; i++) {
            xs[i] = polygon.x(n - 1 - i);
            ys[i] = polygon.y(n - 1 - i);
        }
        return new Polygon(xs, ys);
    }
}
