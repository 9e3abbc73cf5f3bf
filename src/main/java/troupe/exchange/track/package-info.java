/**
 * Writes where everybody is at each instant, for programs that analyse pedestrians and for tables; and works out
 * where one can walk, as polygons with holes.
 *
 * <p>Guarantees: rings that do not touch themselves, outlines counter-clockwise and holes clockwise. May use
 * {@code exchange.format}, {@code paint.motion}, {@code run}, {@code scene}, {@code geometry} and
 * {@code java.awt.geom}.
 */
package troupe.exchange.track;
