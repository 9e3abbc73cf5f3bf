/**
 * Measures the grid core and the planner with JMH, each beside plain-array floors written here.
 *
 * <p>No part of the default build: the Maven profile {@code bench} compiles and runs it.
 */
package troupe.bench;
