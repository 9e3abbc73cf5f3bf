package troupe.geometry;

import java.util.Arrays;

/**
 * Holds a closed polygon in metres: corners in order, either winding, concave allowed, the last
 * corner joined to the first. It is immutable and makes no promise about simplicity or area; the
 * scene's checks report what is wrong with an outline.
 *
 * <p>Inside is decided by the even-odd rule with half-open edges (an upward edge holds its lower end
 * and not its upper one), so that polygons which share an edge tile the plane without gap or double
 * cover.
 */
public final class Polygon {
    private final double[] xs;
    private final double[] ys;
    private final Box bounds;

    /**
     * Makes a polygon of the corners {@code (xs[i], ys[i])}; the arrays are copied.
     *
     * @throws IllegalArgumentException if the arrays differ in length or hold no corner
     */
    public Polygon(double[] xs, double[] ys) {
        if (xs.length != ys.length || xs.length == 0) {
            throw new IllegalArgumentException(
                    "polygon of " + xs.length + " x and " + ys.length + " y values; needs as many of each, at least 1");
        }
        this.xs = xs.clone();
        this.ys = ys.clone();
        double minX = xs[0];
        double maxX = xs[0];
        double minY = ys[0];
        double maxY = ys[0];
        for (int i = 1; i < xs.length; i++) {
            minX = Math.min(minX, xs[i]);
            maxX = Math.max(maxX, xs[i]);
            minY = Math.min(minY, ys[i]);
            maxY = Math.max(maxY, ys[i]);
        }
        this.bounds = new Box(minX, minY, maxX, maxY);
    }

    /** Makes the polygon of corners given as {@code x0, y0, x1, y1, …}. */
    public static Polygon of(double... coordinates) {
        double[] xs = new double[coordinates.length / 2];
        double[] ys = new double[coordinates.length / 2];
        for (int i = 0; i < xs.length; i++) {
            xs[i] = coordinates[2 * i];
            ys[i] = coordinates[2 * i + 1];
        }
        return new Polygon(xs, ys);
    }

    /** Makes the axis-parallel rectangle with the given opposite corners, counter-clockwise. */
    public static Polygon rectangle(double minX, double minY, double maxX, double maxY) {
        return of(minX, minY, maxX, minY, maxX, maxY, minX, maxY);
    }

    /** Returns the number of corners, at least 1. */
    public int size() {
        return xs.length;
    }

    /** Returns the x of corner {@code i} in metres, {@code 0 <= i < size()}. */
    public double x(int i) {
        return xs[i];
    }

    /** Returns the y of corner {@code i} in metres, {@code 0 <= i < size()}. */
    public double y(int i) {
        return ys[i];
    }

    /** Returns the smallest box that holds every corner. */
    public Box bounds() {
        return bounds;
    }

    /** Returns the signed area in square metres, positive when the corners run counter-clockwise. Cost O(n). */
    public double signedArea() {
        double sum = 0;
        for (int i = 0, j = xs.length - 1; i < xs.length; j = i++) {
            sum += (xs[j] - xs[0]) * (ys[i] - ys[0]) - (xs[i] - xs[0]) * (ys[j] - ys[0]);
        }
        return sum / 2;
    }

    /** Returns the centroid of the area, or the mean of the corners where the area is zero. Cost O(n). */
    public Point centroid() {
        double area = 0;
        double cx = 0;
        double cy = 0;
        double x0 = xs[0];
        double y0 = ys[0];
        for (int i = 0, j = xs.length - 1; i < xs.length; j = i++) {
            double cross = (xs[j] - x0) * (ys[i] - y0) - (xs[i] - x0) * (ys[j] - y0);
            area += cross;
            cx += (xs[j] + xs[i] - 2 * x0) * cross;
            cy += (ys[j] + ys[i] - 2 * y0) * cross;
        }
        if (area == 0) {
            return new Point(
                    Arrays.stream(xs).sum() / xs.length, Arrays.stream(ys).sum() / ys.length);
        }
        return new Point(x0 + cx / (3 * area), y0 + cy / (3 * area));
    }

    /** Tells whether {@code (x, y)} is inside: even-odd, half-open edges. Cost O(n). */
    public boolean contains(double x, double y) {
        if (!bounds.contains(x, y)) {
            return false;
        }
        boolean inside = false;
        for (int i = 0, j = xs.length - 1; i < xs.length; j = i++) {
            if ((ys[i] <= y) != (ys[j] <= y) && x < crossing(i, j, y)) {
                inside = !inside;
            }
        }
        return inside;
    }

    /** Returns the x at which edge {@code (i, j)} crosses height {@code y}, the same for either order of its ends. */
    private double crossing(int i, int j, double y) {
        int low = ys[i] <= ys[j] ? i : j;
        int high = low == i ? j : i;
        return xs[low] + (y - ys[low]) * (xs[high] - xs[low]) / (ys[high] - ys[low]);
    }

    /** Returns the distance in metres from {@code (x, y)} to the outline, inside or out. Cost O(n). */
    public double distanceToOutline(double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0, j = xs.length - 1; i < xs.length; j = i++) {
            least = Math.min(least, Segments.distanceSquared(x, y, xs[j], ys[j], xs[i], ys[i]));
        }
        return Math.sqrt(least);
    }

    /** Returns the distance in metres from {@code (x, y)} to the filled polygon, 0 inside. Cost O(n). */
    public double distance(double x, double y) {
        return contains(x, y) ? 0 : distanceToOutline(x, y);
    }

    /** Returns this polygon shifted by {@code (dx, dy)} metres. */
    public Polygon shifted(double dx, double dy) {
        double[] nx = new double[xs.length];
        double[] ny = new double[ys.length];
        for (int i = 0; i < xs.length; i++) {
            nx[i] = xs[i] + dx;
            ny[i] = ys[i] + dy;
        }
        return new Polygon(nx, ny);
    }

    /**
     * Returns this polygon turned by the pose's heading about its centroid, and its centroid carried to
     * the pose's position. The pose {@code (centroid, 0)} gives the polygon itself.
     */
    public Polygon at(Pose pose) {
        Point c = centroid();
        double cos = StrictMath.cos(pose.headingRad());
        double sin = StrictMath.sin(pose.headingRad());
        double[] nx = new double[xs.length];
        double[] ny = new double[ys.length];
        for (int i = 0; i < xs.length; i++) {
            double dx = xs[i] - c.x();
            double dy = ys[i] - c.y();
            nx[i] = pose.x() + cos * dx - sin * dy;
            ny[i] = pose.y() + sin * dx + cos * dy;
        }
        return new Polygon(nx, ny);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Polygon p && Arrays.equals(xs, p.xs) && Arrays.equals(ys, p.ys);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(xs) + Arrays.hashCode(ys);
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("Polygon[");
        for (int i = 0; i < xs.length; i++) {
            text.append(i == 0 ? "" : " ").append(xs[i]).append(',').append(ys[i]);
        }
        return text.append(']').toString();
    }
}
