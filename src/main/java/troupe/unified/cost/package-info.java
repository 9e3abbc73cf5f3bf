/**
 * Knows what each step of an actor costs, which steps are legal for it, and what is still to go: the costs in
 * whole units, the exact bound that is found backwards as far as it is asked for, the orders that are built on it.
 *
 * <p>Guarantees: a bound is never above the cost that is left, and exact where it says so. Uses {@code search},
 * {@code grid}, {@code scene}.
 *
 * <p>Source: Unified figures 6 and 7; deviations are listed in {@code docs/unified.md}.
 */
package troupe.unified.cost;
