/**
 * Paints a scene as it is drawn: obstacles by height, ditches, layers and their elevations, starts and goals.
 *
 * <p>May use {@code paint}, {@code scene} and {@code geometry}.
 */
package troupe.paint.scene;
