/**
 * Writes the run that is shown in any format, with a preview of what will be written.
 *
 * <p>Guarantees: previews and files are made on a background thread; a file is there whole or not at all. Belongs
 * to the event thread. May use {@code exchange} and below.
 */
package troupe.app.export;
