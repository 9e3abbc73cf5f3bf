/**
 * Moves one obstacle out of the way: its poses, the poses in which it bars an expected path, which motions
 * have room and support, and the resumable search for a place to put it.
 *
 * <p>Guarantees: the result depends on the question alone, however the work is sliced; motions are checked
 * on the polygons. Uses {@code unified.body}, {@code search}, {@code grid},
 * {@code scene}, {@code geometry}.
 *
 * <p>Source: Unified section 6; deviations are listed in {@code docs/unified.md}.
 */
package troupe.unified.manipulation;
