/**
 * Computes fields over a region: NF1, and NF2 with its fronts, skeleton and potential.
 *
 * <p>Guarantees: no local minimum but the goal; a result depends on region, goal and order alone. Uses
 * {@code grid.region}, {@code grid}, {@code scene}.
 *
 * <p>Source: Latombe 1991, chapter 7; Crowd section 3.3; deviations are listed in {@code docs/fields.md}.
 */
package troupe.grid.field;
