/**
 * Writes scripts that rebuild a run in programs for animation: one class for each language, behind one interface.
 *
 * <p>Guarantees: plain ASCII, the same in any locale, and nothing of a scene's texts is executed. May use
 * {@code exchange.format}, {@code paint.motion}, {@code run}, {@code scene}, {@code geometry} and {@code java.awt.Color}.
 */
package troupe.exchange.script;
