/**
 * Shows the scene from above and lets the pointer work on it: viewport, layers, tools.
 *
 * <p>Guarantees: what lies below the lowest changed layer is not painted again; a tool shows a preview
 * while the button is down and commits one edit on release. Belongs to the event thread.
 */
package troupe.app.canvas;
