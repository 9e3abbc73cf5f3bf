/**
 * Holds the grid core: frame, layered spans, clearance, classes and crossings, reachable region, NF1 and
 * NF2.
 *
 * <p>Guarantees: fields are flat primitive arrays over a {@link troupe.grid.GridFrame}; kernels allocate
 * nothing in their loops; a result depends on nothing but its input. May use {@code search}, {@code scene},
 * {@code geometry}.
 *
 * <p>Sources: Unified sections 3, 5 and 6; Crowd sections 3.3 and 3.4; Latombe 1991, chapter 7.
 */
package troupe.grid;
