/**
 * Shows the scene in three dimensions beside the plan, turned by dragging.
 *
 * <p>Guarantees: pictures are made on a background thread, the newest wish wins; everything else belongs to the
 * event thread.
 */
package troupe.app.solid;
