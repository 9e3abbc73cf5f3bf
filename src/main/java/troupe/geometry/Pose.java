package troupe.geometry;

/**
 * Holds a position and a heading in the plane: metres and radians, counter-clockwise from +x.
 * Of an obstacle it is the pose of its area centroid, with heading 0 as drawn.
 */
public record Pose(double x, double y, double headingRad) {}
