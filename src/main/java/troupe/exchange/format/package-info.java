/**
 * Holds what every format has in common: importers and exporters as interfaces, the choices of an export, the
 * instants and places of a run that exporters ask for.
 *
 * <p>Guarantees: bad input gives one declared exception with place and cure; output is written whole or not at all,
 * the same in any locale. May use {@code paint}, {@code run},
 * {@code scene} and {@code geometry}.
 */
package troupe.exchange.format;
