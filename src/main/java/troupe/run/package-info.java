/**
 * Holds what any planner hands out: the engine of a task at work, the run with its report, and what compares runs.
 * Below it lie frames, views, run files and journals.
 *
 * <p>Guarantees: a run is immutable; equal scene, settings and seed give equal frames, bit by bit, and so
 * an equal digest. May use {@code run.frame}, {@code run.view}, {@code grid}, {@code scene}, {@code geometry} and
 * the outcome of {@code search}.
 */
package troupe.run;
