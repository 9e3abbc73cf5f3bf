/**
 * Finds out what is wrong with a scene and what to do about it: problems with fixes at hand, and what stands in
 * the way where a plan fails.
 *
 * <p>Guarantees: looks in the background, at the newest plan only; what it offers is tried before it is called
 * a way out. May use {@code work}, {@code app.plan}, {@code app.session} and {@code app.document}.
 */
package troupe.app.problem;
