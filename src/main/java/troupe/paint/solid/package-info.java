/**
 * Draws flat faces and lines in space by parallel projection, nearer ones over farther ones pixel by pixel.
 *
 * <p>Guarantees: knows no scene; the same on each run of one JDK. A camera is immutable, a raster serves one
 * thread. May use {@code geometry} and {@code java.awt}.
 */
package troupe.paint.solid;
