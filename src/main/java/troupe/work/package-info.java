/**
 * Holds the registry that starts any task, and the golden runs.
 *
 * <p>Guarantees: every front starts a task the same way; results do not depend on the number of threads.
 * May use everything but the fronts.
 */
package troupe.work;
