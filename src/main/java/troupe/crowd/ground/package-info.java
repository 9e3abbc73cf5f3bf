/**
 * Tells where the agents of one radius can stand and step, exactly on the polygons near walls, and which way leads
 * down a potential to a goal. Uses the grid core; immutable after it is built but for caches that give the same
 * values to every thread. Source: Crowd sections 3.3 and 3.4.
 */
package troupe.crowd.ground;
