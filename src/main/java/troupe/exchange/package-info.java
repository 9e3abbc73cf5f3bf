/**
 * Holds importers and exporters: what comes from other programs and what goes to them.
 *
 * <p>Guarantees: bad input gives one declared exception with place and cure; output is written whole or not
 * at all, the same in any locale. May use {@code paint}, {@code run}, {@code grid}, {@code scene},
 * {@code geometry} and {@code java.awt}.
 */
package troupe.exchange;
