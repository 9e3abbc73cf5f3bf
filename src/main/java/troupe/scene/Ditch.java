package troupe.scene;

import troupe.geometry.Polygon;

/** Holds a polygon where the ground lies at {@code -depth} metres; where ditches overlap the deepest counts. */
public record Ditch(String id, String label, Polygon outline, double depth) implements Element {

    /** Returns this ditch with another outline. */
    public Ditch withOutline(Polygon changed) {
        return new Ditch(id, label, changed, depth);
    }

    @Override
    public Ditch named(String otherId, String otherLabel) {
        return new Ditch(otherId, otherLabel, outline, depth);
    }
}
