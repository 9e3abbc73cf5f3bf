/**
 * Holds what any planner hands out: the engine of a task at work, frames with named channels, overlays,
 * the report, the run file and its replay.
 *
 * <p>Guarantees: a run is immutable; equal scene, settings and seed give equal frames, bit by bit, and so
 * an equal digest; reading a run file needs no planner, is bounded in memory, and refuses what is damaged
 * with one {@code RunException}. May use {@code grid}, {@code scene}, {@code geometry} and the
 * outcome of {@code search}.
 */
package troupe.run;
