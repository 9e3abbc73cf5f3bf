/**
 * Measures the risk planner: seeded random encounters, actors in the place of recorded walkers, and how well
 * predictions are calibrated.
 *
 * <p>Guarantees: the same seed gives the same encounter. May use {@code risk}, {@code run}, {@code scene},
 * {@code geometry}.
 */
package troupe.risk.study;
