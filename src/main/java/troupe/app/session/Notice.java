package troupe.app.session;

/**
 * Tells the person something in one line.
 *
 * @param wrong whether something went wrong
 * @param text what happened, where, and what to do
 */
public record Notice(boolean wrong, String text) {}
