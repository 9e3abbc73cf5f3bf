/**
 * Holds the painters of scenes, overlays and runs, with viewport, theme and legends.
 *
 * <p>Guarantees: a painter is a pure function of graphics, subject, viewport and theme; it runs without a
 * window, on any thread, at any scale. May use {@code run}, {@code grid}, {@code scene}, {@code geometry}
 * and {@code java.awt}.
 */
package troupe.paint;
