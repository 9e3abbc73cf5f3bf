package troupe.paint.scene;

import java.util.ArrayList;
import java.util.List;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Knows what hangs over a place, so that what passes below can be drawn faintly. */
public final class Cover {
    private static final double PIECE = 0.05;
    private static final int MAX_PIECES = 2_000;

    private final List<Obstacle> hanging;

    /** Makes the cover of a scene. */
    public Cover(Scene scene) {
        hanging = ObstacleLook.of(scene.obstacles()).stream()
                .filter(ObstacleLook::hanging)
                .map(ObstacleLook::obstacle)
                .toList();
    }

    /** Tells whether something hangs above a place at elevation {@code z}. Cost O(hanging obstacles). */
    public boolean over(double x, double y, double z) {
        for (Obstacle o : hanging) {
            if (o.offset() > z + 0.5 && o.outline().contains(x, y)) {
                return true;
            }
        }
        return false;
    }

    /** A part of a line, {@code x0, y0, x1, y1, …} in metres. */
    public record Part(double[] coordinates, boolean covered) {}

    /** Cuts a line of x, y, z triples where it goes below something or comes out. */
    public List<Part> parts(List<double[]> points) {
        List<Part> parts = new ArrayList<>();
        List<double[]> part = new ArrayList<>();
        boolean covered = false;
        for (int i = 0; i < points.size(); i++) {
            double[] to = points.get(i);
            double[] from = points.get(Math.max(0, i - 1));
            double length = Math.hypot(to[0] - from[0], to[1] - from[1]);
            int pieces = hanging.isEmpty() ? 1 : (int) Math.max(1, Math.min(MAX_PIECES, Math.ceil(length / PIECE)));
            for (int k = 1; k <= pieces; k++) {
                double share = (double) k / pieces;
                double[] p = {
                    from[0] + share * (to[0] - from[0]),
                    from[1] + share * (to[1] - from[1]),
                    from[2] + share * (to[2] - from[2])
                };
                boolean over = over(p[0], p[1], p[2]);
                if (over != covered && !part.isEmpty()) {
                    part.add(p);
                    parts.add(new Part(flat(part), covered));
                    part.clear();
                }
                covered = over;
                part.add(p);
            }
        }
        if (part.size() > 1) {
            parts.add(new Part(flat(part), covered));
        }
        return parts;
    }

    private static double[] flat(List<double[]> points) {
        double[] flat = new double[2 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            flat[2 * i] = points.get(i)[0];
            flat[2 * i + 1] = points.get(i)[1];
        }
        return flat;
    }
}
