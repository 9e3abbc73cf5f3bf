/**
 * Runs many tasks side by side and gathers their results in the order in which they were asked for.
 *
 * <p>Guarantees: rows do not depend on the number of threads. May use {@code work} and everything below it.
 */
package troupe.work.batch;
