/**
 * Moves the agents of a crowd by one step: arrays by field, neighbours from a counting-sorted cell list, the forces,
 * and the rounds in which proposals are settled without overlap. Source: Crowd sections 3.1, 3.2, 3.4 and 3.5;
 * Reynolds 1987.
 */
package troupe.crowd.flock;
