package troupe.unified.obstacle;

/**
 * Names a pose of a movable obstacle on the lattice anchored at its own: {@code i} and {@code j} cells along
 * x and y, and {@code k} of the lattice's headings, {@code 0 <= k < headings}, counter-clockwise.
 */
public record LatticePose(int i, int j, int k) {
    /** The pose in which the scene shows the obstacle. */
    public static final LatticePose HOME = new LatticePose(0, 0, 0);
}
