/**
 * Holds plane geometry in metres and radians: points, polygons, rigid motions, robust predicates and
 * the polygon raster.
 *
 * <p>Guarantees: values are immutable, results do not depend on the machine (StrictMath where Math may
 * differ), degenerate input gives a documented answer instead of an exception. Uses nothing else.
 */
package troupe.geometry;
