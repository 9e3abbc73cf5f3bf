/**
 * Searches a region for the way of an actor with all its abilities: labels, legal steps, orderings, cost to
 * go.
 *
 * <p>Guarantees: a legal way is found whenever there is one, of least cost with the optimal ordering; slicing
 * changes nothing. Uses {@code search}, {@code grid}, {@code scene}.
 *
 * <p>Source: Unified figures 6 and 7; deviations are listed in {@code docs/unified.md}.
 */
package troupe.unified.search;
