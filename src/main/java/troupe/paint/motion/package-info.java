/**
 * Paints what moves in a run at a moment: actors, avatars, crowds, what is carried along, and the ways they took.
 *
 * <p>May use {@code paint}, {@code paint.scene}, {@code run}, {@code scene} and {@code geometry}.
 */
package troupe.paint.motion;
