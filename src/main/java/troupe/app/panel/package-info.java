/**
 * Holds the panels around the canvas: tools, outline, views, history, status; inspector and timeline lie below.
 *
 * <p>Guarantees: a panel shows the session and changes it through commits and previews; it keeps nothing
 * of its own. Belongs to the event thread.
 */
package troupe.app.panel;
