/**
 * Holds the unified planner: one best-first search over walking, sidestepping, striding and vaulting, on
 * one scale of energy.
 *
 * <p>Guarantees: on the grid a legal path is found whenever one exists, and with the optimal ordering it
 * has least cost. May use {@code run}, {@code search}, {@code grid}, {@code scene}, {@code geometry}.
 *
 * <p>Source: Unified (Li and Li), figures 6 and 7; deviations are listed in {@code docs/unified.md}.
 */
package troupe.unified;
