package troupe.app.canvas;

import troupe.geometry.Point;

/**
 * Says where the pointer is and which keys are held.
 *
 * @param at the place in metres
 * @param px the pixel column, {@code py} the pixel row
 */
public record Pointer(Point at, double px, double py, boolean shift, boolean alt) {}
