/**
 * Holds what the studio edits: the document with its revision, the undo history and the selection.
 *
 * <p>Guarantees: everything here lives on the event thread and says so when called from another; a scene
 * that was handed out never changes. May use {@code scene}, {@code geometry} and the texts of
 * {@code app.look}.
 */
package troupe.app.document;
