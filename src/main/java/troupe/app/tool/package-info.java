/**
 * Holds what tools share: pointer, snapping, hits, the sketch of what is being drawn; and the tools that change
 * nothing. Those that draw and select lie below.
 *
 * <p>Guarantees: a tool shows a preview while the button is down and commits one named edit on release; what
 * is cancelled leaves no trace; what is not right is said at once and never dropped silently. Belongs to the
 * event thread; runs no planner. May use {@code app.document}, {@code app.look}, {@code paint}, {@code scene}
 * and {@code geometry}.
 */
package troupe.app.tool;
