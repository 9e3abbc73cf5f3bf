/**
 * Ties one document to its planner, its playback and its file: everything of a studio but the window.
 *
 * <p>Guarantees: works without a display; reads and writes files on a background thread. Belongs to the
 * event thread.
 */
package troupe.app.session;
