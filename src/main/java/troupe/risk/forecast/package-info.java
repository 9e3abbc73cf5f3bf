/**
 * Predicts where avatars will be, from their past alone: a Gaussian that grows with time, clipped where walls keep
 * them from, and the risk that it means for a move of the actor.
 *
 * <p>Guarantees: the same past gives the same bits; nothing is allocated once a forecast has been made. May use
 * {@code grid}, {@code scene}, {@code search}, {@code geometry}.
 *
 * <p>Source: Avatars, section 3, equations 1 to 5; deviations are listed in {@code docs/risk.md}.
 */
package troupe.risk.forecast;
