/**
 * Gives the studio its looks: texts, colours and fonts of the Swing parts, icons drawn in code.
 *
 * <p>Guarantees: knows nothing of documents or planners; no state but in components. May use
 * {@code paint} and {@code scene}.
 */
package troupe.app.look;
