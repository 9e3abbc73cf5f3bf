package troupe.crowd.ground;

import java.util.Arrays;
import troupe.geometry.Polygon;
import troupe.geometry.Segments;
import troupe.grid.GridFrame;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Holds, for each cell, the edges of obstacles, ditches and the world that a disc whose centre lies in the cell may
 * touch. Immutable. Memory: an int for each pair of cell and edge.
 */
final class Walls {
    private static final double HALF_DIAGONAL = 0.70711;

    private final double[] ax;
    private final double[] ay;
    private final double[] bx;
    private final double[] by;
    private final double[] bottom;
    private final double[] top;
    private int count;
    private final int[] first;
    private final int[] edges;

    /** Collects the edges for discs of at most {@code radius} metres. Cost O(cells + cells near edges). */
    Walls(Scene scene, GridFrame frame, double radius) {
        int most = 4
                + scene.obstacles().stream().mapToInt(o -> o.outline().size()).sum()
                + scene.ditches().stream().mapToInt(d -> d.outline().size()).sum();
        ax = new double[most];
        ay = new double[most];
        bx = new double[most];
        by = new double[most];
        bottom = new double[most];
        top = new double[most];
        for (Obstacle o : scene.obstacles()) {
            add(o.outline(), o.offset(), o.top());
        }
        for (Ditch ditch : scene.ditches()) {
            add(ditch.outline(), Double.NEGATIVE_INFINITY, 0);
        }
        Polygon world =
                Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth());
        add(world, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
        double reach = radius + HALF_DIAGONAL * frame.cell();
        int[] counts = new int[frame.size() + 1];
        for (int e = 0; e < count; e++) {
            visit(frame, e, reach, (cell, edge) -> counts[cell + 1]++);
        }
        for (int cell = 0; cell < frame.size(); cell++) {
            counts[cell + 1] += counts[cell];
        }
        first = counts;
        edges = new int[counts[frame.size()]];
        int[] place = Arrays.copyOf(counts, frame.size());
        for (int e = 0; e < count; e++) {
            visit(frame, e, reach, (cell, edge) -> edges[place[cell]++] = edge);
        }
    }

    private void add(Polygon outline, double from, double to) {
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            ax[count] = outline.x(j);
            ay[count] = outline.y(j);
            bx[count] = outline.x(i);
            by[count] = outline.y(i);
            bottom[count] = from;
            top[count++] = to;
        }
    }

    /** Takes a cell and an edge near it. */
    private interface Visitor {
        void take(int cell, int edge);
    }

    private void visit(GridFrame frame, int e, double reach, Visitor visitor) {
        int left = Math.max(0, frame.colAt(Math.min(ax[e], bx[e]) - reach));
        int right = Math.min(frame.cols() - 1, frame.colAt(Math.max(ax[e], bx[e]) + reach));
        int low = Math.max(0, frame.rowAt(Math.min(ay[e], by[e]) - reach));
        int high = Math.min(frame.rows() - 1, frame.rowAt(Math.max(ay[e], by[e]) + reach));
        for (int row = low; row <= high; row++) {
            double y = frame.centreY(row);
            for (int col = left; col <= right; col++) {
                double d = Segments.distanceSquared(frame.centreX(col), y, ax[e], ay[e], bx[e], by[e]);
                if (d <= reach * reach) {
                    visitor.take(frame.index(col, row), e);
                }
            }
        }
    }

    /**
     * Tells whether a disc keeps clear of every edge that meets a stretch of height.
     *
     * @param cell the cell that holds {@code (x, y)}
     * @param from the height in metres from which the body is stopped
     * @param to the height in metres of its upper end
     */
    boolean clear(int cell, double x, double y, double radius, double from, double to) {
        double squared = radius * radius;
        for (int k = first[cell]; k < first[cell + 1]; k++) {
            int e = edges[k];
            if (top[e] > from
                    && bottom[e] < to
                    && Segments.distanceSquared(x, y, ax[e], ay[e], bx[e], by[e]) < squared) {
                return false;
            }
        }
        return true;
    }
}
