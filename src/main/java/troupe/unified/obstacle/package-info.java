/**
 * Works out what a movable obstacle can do, pose by pose on its lattice: where it stands free and supported, whether
 * it can be shifted or turned from there, and how somebody holds it meanwhile.
 *
 * <p>Guarantees: what is allowed is collision-free on the polygons all the way; tables are filled on demand and serve
 * one search. Uses {@code grid}, {@code scene} and {@code geometry}. Source: Unified section 6; deviations are listed
 * in {@code docs/unified.md}.
 */
package troupe.unified.obstacle;
