/**
 * Compares the run that is shown with another, and opens and saves run files.
 *
 * <p>Guarantees: run files are read and written on a background thread. Belongs to the event thread.
 */
package troupe.app.compare;
