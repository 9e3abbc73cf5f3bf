/**
 * Holds the checks of a scene that need the grid: who has no room, no way, and what is in the way.
 *
 * <p>Guarantees: a check never throws and never changes anything. May use {@code work}, {@code work.view} and
 * everything below them.
 */
package troupe.work.inspect;
