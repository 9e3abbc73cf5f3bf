/**
 * Finds where one can get across what one cannot stand on: strides over gaps and vaults over obstacles.
 *
 * <p>Guarantees: every crossing holds on the polygons. Uses {@code grid.region.ground} and what it uses. Source: Unified
 * section 3.
 */
package troupe.grid.region.crossing;
