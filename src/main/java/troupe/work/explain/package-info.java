/**
 * Works out what a plan costs by ability, and at which preference another plan becomes the cheaper one.
 *
 * <p>May use {@code unified}, {@code run} and {@code scene}. Source: Unified section 4; {@code docs/explain.md}.
 */
package troupe.work.explain;
