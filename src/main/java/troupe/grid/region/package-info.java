/**
 * Holds the configurations of one actor profile: clearance, classes, crossings, legal steps, the reachable
 * region.
 *
 * <p>Guarantees: classes agree with the distances to the polygons; a region is immutable and may be shared
 * between threads. Uses {@code grid.layer}, {@code grid}, {@code scene}, {@code geometry}.
 *
 * <p>Source: Unified sections 3, 5 and 7; deviations are listed in {@code docs/grid.md}.
 */
package troupe.grid.region;
