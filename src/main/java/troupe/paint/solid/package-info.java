/**
 * Draws a scene and its run in space: flat faces and lines by parallel projection, nearer ones over farther ones
 * pixel by pixel.
 *
 * <p>Guarantees: the same on each run of one JDK. A camera is immutable, a raster serves one thread. May use
 * {@code paint}, {@code paint.scene}, {@code paint.motion}, {@code run}, {@code scene} and {@code geometry}.
 */
package troupe.paint.solid;
