package troupe.unified.manipulation;

import troupe.grid.GridFrame;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;

/**
 * Holds the places that an actor expects to pass once an obstacle is out of its way, from the trigger to
 * the goal (Unified section 6.3). Each is a cell with a floor and the radius that the body has there.
 * Immutable; the arrays are copied.
 */
public final class ExpectedPath {
    private final GridFrame frame;
    private final double bodyHeight;
    private final int[] cells;
    private final double[] floors;
    private final double[] radii;
    private final double length;

    /**
     * Makes a path of places that are neighbours in turn.
     *
     * @param frame the world's frame
     * @param bodyHeight of the actor in metres
     * @param cells one or more cells of the frame
     * @param floors the elevation in metres of the floor of each place; of a crossing that of the take-off
     * @param radii the radius in metres of the body at each place
     * @throws IllegalArgumentException if there is no place or the lengths differ
     */
    public ExpectedPath(GridFrame frame, double bodyHeight, int[] cells, double[] floors, double[] radii) {
        if (cells.length == 0 || floors.length != cells.length || radii.length != cells.length) {
            throw new IllegalArgumentException("path of " + cells.length + " cells, " + floors.length + " floors and "
                    + radii.length + " radii; needs as many of each, at least 1");
        }
        this.frame = frame;
        this.bodyHeight = bodyHeight;
        this.cells = cells.clone();
        this.floors = floors.clone();
        this.radii = radii.clone();
        int straight = 0;
        int diagonal = 0;
        for (int n = 1; n < cells.length; n++) {
            boolean slanted =
                    frame.col(cells[n]) != frame.col(cells[n - 1]) && frame.row(cells[n]) != frame.row(cells[n - 1]);
            diagonal += slanted ? 1 : 0;
            straight += slanted || cells[n] == cells[n - 1] ? 0 : 1;
        }
        this.length = straight * frame.stepLength(0) + diagonal * frame.stepLength(4);
    }

    /** Returns the number of places, at least 1. */
    public int size() {
        return cells.length;
    }

    /** Returns the frame. */
    public GridFrame frame() {
        return frame;
    }

    /** Returns the cell of place {@code n}, {@code 0 <= n < size()}. */
    public int cell(int n) {
        return cells[n];
    }

    /** Returns the elevation in metres of the floor of place {@code n}. */
    public double floor(int n) {
        return floors[n];
    }

    /** Returns the radius in metres of the body at place {@code n}. */
    public double radius(int n) {
        return radii[n];
    }

    /** Returns the length in metres along the grid. */
    public double length() {
        return length;
    }

    /**
     * Returns the first place that collides with an obstacle at a lattice pose, -1 if none does: their
     * vertical stretches meet, and the obstacle is nearer to the cell's centre than the radius. Cost O(places).
     */
    public int firstCollision(Movable movable, LatticePose pose) {
        for (int n = 0; n < cells.length; n++) {
            if (collides(n, movable, pose)) {
                return n;
            }
        }
        return -1;
    }

    /** Tells whether some place collides with an obstacle at a lattice pose. Cost O(places). */
    public boolean collides(Movable movable, LatticePose pose) {
        return firstCollision(movable, pose) >= 0;
    }

    /** Tells whether place {@code n} collides with an obstacle at a lattice pose. */
    public boolean collides(int n, Movable movable, LatticePose pose) {
        return meets(n, movable)
                && movable.isNear(pose.i(), pose.j(), pose.k(), frame.col(cells[n]), frame.row(cells[n]), radii[n]);
    }

    /** Tells whether the stretch of the body at place {@code n} meets that of the obstacle. */
    boolean meets(int n, Movable movable) {
        return movable.meets(floors[n], bodyHeight);
    }
}
