package troupe.unified.manipulation;

import java.util.Random;
import troupe.geometry.Line;
import troupe.geometry.Polygon;

/** Makes random simple outlines, convex and concave, and measures between two of them. */
public final class Shapes {
    private Shapes() {}

    /** Returns a star-shaped polygon about a point: three to eight corners at random distances. */
    public static Polygon star(Random random, double x, double y, double size) {
        int corners = 3 + random.nextInt(6);
        double[] xs = new double[corners];
        double[] ys = new double[corners];
        for (int n = 0; n < corners; n++) {
            double angle = 2 * Math.PI * (n + 0.8 * random.nextDouble()) / corners;
            double reach = size * (0.35 + 0.65 * random.nextDouble());
            xs[n] = x + reach * Math.cos(angle);
            ys[n] = y + reach * Math.sin(angle);
        }
        return new Polygon(xs, ys);
    }

    /** Returns a rectangle, a turned rectangle, an L or a star within {@code size} of a point. */
    public static Polygon any(Random random, double x, double y, double size) {
        double a = size * (0.3 + 0.4 * random.nextDouble());
        double b = size * (0.3 + 0.4 * random.nextDouble());
        return switch (random.nextInt(3)) {
            case 0 -> Polygon.rectangle(x - a, y - b, x + a, y + b);
            case 1 -> Polygon.of(x - a, y - b, x + a, y - b, x + a, y - b / 3, x, y - b / 3, x, y + b, x - a, y + b);
            default -> star(random, x, y, size);
        };
    }

    /** Returns the distance in metres between two outlines. */
    public static double distance(Polygon a, Polygon b) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0, j = a.size() - 1; i < a.size(); j = i++) {
            least = Math.min(least, new Line(a.x(j), a.y(j), a.x(i), a.y(i)).distance(b));
        }
        return least;
    }
}
