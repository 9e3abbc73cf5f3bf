/**
 * Works out where one can walk, as polygons with holes for programs that analyse pedestrians.
 *
 * <p>Guarantees: rings that do not touch themselves, outlines counter-clockwise and holes clockwise. May use
 * {@code scene}, {@code geometry} and {@code java.awt.geom}.
 */
package troupe.exchange.ground;
