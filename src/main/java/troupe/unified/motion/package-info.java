/**
 * Turns a way over the grid into motion: pulls it taut, checks it on the polygons, and travels it at the
 * abilities' speeds.
 *
 * <p>Guarantees: no frame is nearer to a polygon than the ability allows, up to the bound in {@code
 * docs/unified.md}; headings turn at a bounded rate. Uses {@code unified.body}, {@code unified.search}, {@code run}, {@code grid},
 * {@code scene}, {@code geometry}.
 */
package troupe.unified.motion;
