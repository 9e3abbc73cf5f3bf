/**
 * Searches for the way of an actor with all its abilities: labels, their order, the path; and, where
 * obstacles can be moved, over search spaces: {@code SearchSpace} is the scene with some of them elsewhere, {@code
 * Manipulations} begins the instances that move them, {@code Turn} is what the search buys of one at a time, and an {@code
 * Enclosure} is a part of a space that can be left by moving something only.
 *
 * <p>Guarantees: a legal way is found whenever there is one, of least cost with the optimal ordering; slicing
 * changes nothing. Uses {@code unified.cost}, {@code unified.manipulation}, {@code search}, {@code grid}, {@code scene}.
 *
 * <p>Source: Unified figures 6 and 7; deviations are listed in {@code docs/unified.md}.
 */
package troupe.unified.search;
