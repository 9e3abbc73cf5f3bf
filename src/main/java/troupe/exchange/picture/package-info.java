/**
 * Writes pictures of scenes and runs: PNG, SVG, animated GIF.
 *
 * <p>Guarantees: what the painters draw is what is written, vectors as vectors. May use {@code exchange.format},
 * {@code paint} and {@code java.awt}.
 */
package troupe.exchange.picture;
