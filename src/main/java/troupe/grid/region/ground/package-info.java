/**
 * Works out where and how one can stand: solids around each sheet, standing classes, clearance.
 *
 * <p>Guarantees: classes agree with the distances to the polygons. Uses {@code grid.layer}, {@code grid}, {@code scene},
 * {@code geometry}. Source: Unified section 3.
 */
package troupe.grid.region.ground;
