/**
 * Holds the start page: the example scenes as pictures, the files opened last, new scenes.
 *
 * <p>Guarantees: files are read and pictures made on a background thread; the page belongs to the event thread.
 */
package troupe.app.start;
