/**
 * Plans the way of an actor in place and time among forecast avatars, and keeps the plan up to date.
 *
 * <p>Guarantees: a plan keeps to legal steps of the region and away from what is certain; sliced or whole, it is
 * the same. May use {@code risk.forecast}, {@code grid}, {@code scene}, {@code search}, {@code geometry}.
 *
 * <p>Source: Avatars, section 4, figures 5 and 7 to 9; deviations are listed in {@code docs/risk.md}.
 */
package troupe.risk.plan;
