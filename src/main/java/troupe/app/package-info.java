/**
 * Holds the studio: window, canvas, tools, commands and timeline, a thin front over {@code work}.
 *
 * <p>Guarantees: the event thread holds the document and paints; planning, grid and file code runs on
 * background threads, from snapshots. Uses everything but {@code cli}; the only package that uses Swing.
 */
package troupe.app;
