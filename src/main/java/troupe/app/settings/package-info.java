/**
 * Remembers a person's choices from one start of the studio to the next, and lets him change them.
 *
 * <p>Guarantees: a value that is missing or cannot be read counts as never chosen. Belongs to the event thread.
 */
package troupe.app.settings;
