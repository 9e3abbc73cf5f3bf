package troupe.scene;

import troupe.geometry.Polygon;

/**
 * Holds a polygon that fills the stretch {@code [offset, offset + height]} metres above ground level.
 * Its top can be stood on unless it is movable. {@code mass} is in kg; {@code colour} is
 * {@code #rrggbb} or empty.
 */
public record Obstacle(
        String id,
        String label,
        Polygon outline,
        double offset,
        double height,
        boolean movable,
        double mass,
        String colour)
        implements Element {
    /** Mass in kg of an obstacle that does not name one. */
    public static final double DEFAULT_MASS = 20;

    /** Returns the elevation of the upper face in metres. */
    public double top() {
        return offset + height;
    }

    /** Returns this obstacle with another outline. */
    public Obstacle withOutline(Polygon changed) {
        return new Obstacle(id, label, changed, offset, height, movable, mass, colour);
    }

    @Override
    public Obstacle named(String otherId, String otherLabel) {
        return new Obstacle(otherId, otherLabel, outline, offset, height, movable, mass, colour);
    }
}
