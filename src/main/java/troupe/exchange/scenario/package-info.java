/**
 * Reads the scenarios of other planners: maps and problems of MovingAI, drawings of NAMOSIM.
 *
 * <p>Guarantees: bad input gives one declared exception with place and cure. May use {@code exchange.format},
 * {@code scene} and {@code geometry}.
 */
package troupe.exchange.scenario;
