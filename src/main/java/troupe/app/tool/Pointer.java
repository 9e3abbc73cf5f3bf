package troupe.app.tool;

import troupe.geometry.Point;

/**
 * Says where the pointer is and which keys are held.
 *
 * @param at the place in metres
 * @param px the pixel column, {@code py} the pixel row
 * @param clicks how many presses followed one another at this place, 1 for a single one
 */
public record Pointer(Point at, double px, double py, boolean shift, boolean alt, int clicks) {

    /** Makes a pointer of a single click. */
    public Pointer(Point at, double px, double py, boolean shift, boolean alt) {
        this(at, px, py, shift, alt, 1);
    }

    /** Returns how far it is from another in pixels. */
    public double pixelsTo(Pointer other) {
        return Math.hypot(px - other.px, py - other.py);
    }
}
