/**
 * Holds what every search shares: the indexed heap, the monotone bucket queue, the label pool, the one
 * best-first loop, and its outcome.
 *
 * <p>Guarantees: budgets count expansions, never time; ties are broken by key, then larger cost so far,
 * then insertion number, so that a search sliced in any way takes the same labels in the same order; all
 * state lives in the instance. Uses nothing else.
 */
package troupe.search;
