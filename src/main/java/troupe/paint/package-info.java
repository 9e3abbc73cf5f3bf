/**
 * Holds what all painters share: theme, tones, viewport, labels and marks. The painters lie below.
 *
 * <p>Guarantees: a painter is a pure function of graphics, subject, viewport and theme; it runs without a
 * window, on any thread, at any scale. May use {@code scene}, {@code geometry} and {@code java.awt}.
 */
package troupe.paint;
