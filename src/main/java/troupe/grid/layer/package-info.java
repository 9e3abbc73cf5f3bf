/**
 * Turns the polygons of a scene into spans over cells, and spans into layers.
 *
 * <p>Guarantees: exact at cell centres; flat arrays by sheet; a scene without overhang is one sheet. Uses
 * {@code grid}, {@code scene}, {@code geometry}.
 *
 * <p>Source: Unified section 3; Li and Huang's layered scenes.
 */
package troupe.grid.layer;
