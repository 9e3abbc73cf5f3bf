/**
 * Works out what a plan costs by ability, and at which preference another plan becomes the cheaper one.
 *
 * <p>Guarantees: knows no planner, only reports; keeps nothing between calls. May use {@code run} and {@code scene}.
 * Source: parametric search (Eisner and Severance 1976), see {@code docs/unified.md}.
 */
package troupe.work.explain;
