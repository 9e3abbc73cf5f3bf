/**
 * Holds what any planner hands out: the engine of a task at work, frames with named channels, overlays,
 * the report, and what compares them. Below it lie run files and journals.
 *
 * <p>Guarantees: a run is immutable; equal scene, settings and seed give equal frames, bit by bit, and so
 * an equal digest. May use {@code grid}, {@code scene}, {@code geometry} and the
 * outcome of {@code search}.
 */
package troupe.run;
