/**
 * Holds the risk planner: an actor finds its way among avatars whose future nobody knows, predicts them from their
 * past, and revises its plan at every step.
 *
 * <p>Guarantees: the same scene, task and inputs make the same run, bit by bit; of an uncertain avatar nothing but
 * its past is used. May use {@code run}, {@code search}, {@code grid}, {@code scene}, {@code geometry}.
 *
 * <p>Source: Avatars (Lei and Li); deviations are listed in {@code docs/risk.md}.
 */
package troupe.risk;
