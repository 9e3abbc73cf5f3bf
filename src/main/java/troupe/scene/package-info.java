/**
 * Holds the scene document: immutable records of the world, its obstacles and ditches, the actors and the tasks.
 * Below it lie its checks, its file format and its settings.
 *
 * <p>Guarantees: a scene never changes after it was made. May use {@code geometry}.
 *
 * <p>Source: Unified sections 3 and 5 (polygons with height and offset, actor profile).
 */
package troupe.scene;
