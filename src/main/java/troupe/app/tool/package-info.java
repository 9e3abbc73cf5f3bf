/**
 * Holds the tools that work on the scene with the pointer: selecting and bending, drawing, measuring, and the
 * snapping they share.
 *
 * <p>Guarantees: a tool shows a preview while the button is down and commits one named edit on release; what
 * is cancelled leaves no trace; what is not right is said at once and never dropped silently. Belongs to the
 * event thread; runs no planner. May use {@code app.document}, {@code app.look}, {@code paint}, {@code scene}
 * and {@code geometry}.
 */
package troupe.app.tool;
