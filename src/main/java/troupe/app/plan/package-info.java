/**
 * Plans in the background while the scene is edited.
 *
 * <p>Guarantees: a planner gets an immutable snapshot and a token to cancel it, nothing live; the newest
 * request wins; what comes back for an old revision is dropped. Results are handed over on the event
 * thread. May use {@code work} and below.
 */
package troupe.app.plan;
