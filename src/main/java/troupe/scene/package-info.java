/**
 * Holds the scene document: immutable records, the table of checks, the XML codec and its schema, and
 * the dotted settings that mirror the file.
 *
 * <p>Guarantees: a scene never changes after it was made; what the codec wrote it reads back equal, and
 * writes again byte for byte; every mistake of a file is one {@link troupe.scene.SceneException} or an
 * entry of the list of problems, with element, line and cure. May use {@code geometry}.
 *
 * <p>Source: Unified sections 3 and 5 (polygons with height and offset, actor profile).
 */
package troupe.scene;
