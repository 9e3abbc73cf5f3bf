package troupe.work.view;

import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.run.frame.Frames;
import troupe.run.view.Overlay;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Spreads everybody of a crowd over the ground at one moment: a bell with a standard deviation of {@value #SIGMA} m for
 * each person, whose volume is one. So the field adds up to the number of people, but for what lies outside the world.
 * What of it falls into obstacles that stand on the ground is left out. Used by one thread at a time.
 */
final class CrowdDensity {
    private static final double SIGMA = 0.5;
    private static final double REACH = 3 * SIGMA;
    private static final double LEAST_CELL = 0.2;
    private static final int MOST_CELLS = 240;
    /** Persons for each square metre; less is left plain. */
    private static final float LEAST = 0.05f;

    private final Scene scene;
    private final GridFrame grid;
    private final boolean[] solid;

    /** Surveys the ground of a scene. Cost O(cells x corners of the obstacles). */
    CrowdDensity(Scene scene) {
        this.scene = scene;
        double width = scene.world().width();
        double depth = scene.world().depth();
        double cell = Math.max(LEAST_CELL, Math.max(width, depth) / MOST_CELLS);
        grid = new GridFrame(0, 0, cell, (int) Math.ceil(width / cell), (int) Math.ceil(depth / cell));
        solid = new boolean[grid.size()];
        for (Obstacle obstacle : scene.obstacles()) {
            for (int i = 0; i < solid.length && obstacle.offset() <= 0; i++) {
                solid[i] |= obstacle.outline().contains(grid.centreX(grid.col(i)), grid.centreY(grid.row(i)));
            }
        }
    }

    /** Tells whether it is of this scene. */
    boolean isOf(Scene other) {
        return scene.equals(other);
    }

    /**
     * Returns the density in a frame; NaN where there is hardly anybody. Cost O(people + cells).
     *
     * @param scale how the field is to be read
     */
    Overlay.Field at(Crowd crowd, Frames frames, int frame, Overlay.Scale scale) {
        float[] density = new float[grid.size()];
        double[] across = new double[(int) Math.ceil(2 * REACH / grid.cell()) + 2];
        for (CrowdGroup group : crowd.allGroups().toList()) {
            int x = frames.channel(group.id(), "x");
            int y = frames.channel(group.id(), "y");
            for (int m = 0; x >= 0 && y >= 0 && m < frames.channels().get(x).width(); m++) {
                add(density, across, frames.value(frame, x, m), frames.value(frame, y, m));
            }
        }
        for (int i = 0; i < density.length; i++) {
            density[i] = solid[i] || density[i] < LEAST ? Float.NaN : density[i];
        }
        return new Overlay.Field(MomentViews.DENSITY, 0, grid, density, scale);
    }

    private void add(float[] density, double[] across, double x, double y) {
        int left = Math.max(0, grid.colAt(x - REACH));
        int right = Math.min(grid.cols() - 1, grid.colAt(x + REACH));
        int low = Math.max(0, grid.rowAt(y - REACH));
        int high = Math.min(grid.rows() - 1, grid.rowAt(y + REACH));
        Arrays.fill(across, 0);
        for (int col = left; col <= right; col++) {
            across[col - left] = bell(grid.centreX(col) - x);
        }
        for (int row = low; row <= high; row++) {
            double up = bell(grid.centreY(row) - y) / (2 * Math.PI * SIGMA * SIGMA);
            for (int col = left; col <= right; col++) {
                density[grid.index(col, row)] += (float) (up * across[col - left]);
            }
        }
    }

    private static double bell(double away) {
        return Math.exp(-away * away / (2 * SIGMA * SIGMA));
    }
}
