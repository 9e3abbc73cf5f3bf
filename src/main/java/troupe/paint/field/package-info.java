/**
 * Paints overlays: fields as colours or contours, points and lines.
 *
 * <p>May use {@code paint}, {@code run.view}, {@code grid} and {@code geometry}.
 */
package troupe.paint.field;
