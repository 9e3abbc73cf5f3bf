/**
 * Holds scene files: the reader, the writer, the schema, and what comes beside a scene, such as recorded tracks.
 *
 * <p>Guarantees: what was written reads back equal, and is written again byte for byte; every mistake of a file
 * is one {@link troupe.scene.xml.SceneException} or an entry of the list of problems, with element, line and cure;
 * files are replaced whole or not at all. May use {@code scene}, its checks and settings, and {@code geometry}.
 */
package troupe.scene.xml;
