/**
 * Holds run files and journals: an archive of the scene, the report and the frames in parts, each with its digest,
 * and the journal that a simulation writes while it runs.
 *
 * <p>Guarantees: reading needs no planner, is bounded in memory, and refuses what is damaged with one
 * {@link troupe.run.file.RunException}; files are replaced whole or not at all; what a journal had kept when its
 * writer was killed can be read. May use {@code run}, {@code scene} and {@code geometry}.
 */
package troupe.run.file;
