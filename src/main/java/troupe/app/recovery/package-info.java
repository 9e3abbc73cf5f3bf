/**
 * Keeps edits that are not saved, and what is simulated, in files of their own, and finds them again after the program
 * was ended before its time.
 *
 * <p>Guarantees: files are written and read on background threads, whole or, of simulations, up to
 * a frame; what is kept is removed
 * as soon as the document is saved, given up or closed. A file of another process that still runs is never touched.
 */
package troupe.app.recovery;
