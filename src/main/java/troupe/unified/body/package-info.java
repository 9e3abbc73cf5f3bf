/**
 * Decides on the polygons of a scene, not on its grid, whether a body and its feet fit along a motion.
 *
 * <p>Guarantees: distances are compared in double precision with a slack of 1e-9 m; immutable. Uses
 * {@code scene}, {@code geometry}.
 */
package troupe.unified.body;
