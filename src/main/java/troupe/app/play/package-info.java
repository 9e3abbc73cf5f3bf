/**
 * Plays a run: one clock for live and for saved runs, and what the timeline shows of it.
 *
 * <p>Guarantees: works without a window; belongs to the event thread. May use {@code run} and below.
 */
package troupe.app.play;
