package troupe.unified.manipulation;

import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.scene.Obstacle;

/**
 * Knows the shape of one movable obstacle at every pose of its lattice: steps of a cell, and of a full turn
 * divided by the number of headings, about its area centroid. Immutable.
 */
public final class Movable {
    private final int number;
    private final Obstacle obstacle;
    private final double cell;
    private final int headings;
    private final Point centroid;

    /**
     * Anchors the lattice at the obstacle's own pose.
     *
     * @param number the number of the obstacle among those of the scene
     * @param cell the size of a cell in metres
     * @param headings the number of headings, at least 1
     */
    public Movable(int number, Obstacle obstacle, double cell, int headings) {
        if (headings < 1) {
            throw new IllegalArgumentException("headings=" + headings + "; needs at least 1");
        }
        this.number = number;
        this.obstacle = obstacle;
        this.cell = cell;
        this.headings = headings;
        this.centroid = obstacle.outline().centroid();
    }

    /** Returns the number of the obstacle among those of the scene. */
    public int number() {
        return number;
    }

    /** Returns the obstacle as the scene shows it. */
    public Obstacle obstacle() {
        return obstacle;
    }

    /** Returns the number of headings. */
    public int headings() {
        return headings;
    }

    /** Returns where a lattice pose puts the centroid in metres, and the heading in radians, in [0, 2π). */
    public Pose pose(LatticePose at) {
        return new Pose(centroid.x() + at.i() * cell, centroid.y() + at.j() * cell, at.k() * (2 * Math.PI / headings));
    }

    /** Returns the outline at a lattice pose; the scene's own at {@link LatticePose#HOME}. Cost O(corners). */
    public Polygon outline(LatticePose at) {
        return at.equals(LatticePose.HOME)
                ? obstacle.outline()
                : obstacle.outline().at(pose(at));
    }
}
