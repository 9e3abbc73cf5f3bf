/**
 * Puts whole pictures together from the painters: scene, overlays and run with their legend, moments side by side,
 * animations.
 *
 * <p>May use all of {@code paint}.
 */
package troupe.paint.picture;
