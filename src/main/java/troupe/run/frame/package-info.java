/**
 * Holds the frames of a run: named channels of numbers, recorded in blocks.
 *
 * <p>Guarantees: frames never change once they were recorded; reading one allocates nothing but its array.
 */
package troupe.run.frame;
