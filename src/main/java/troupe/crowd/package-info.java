/**
 * Simulates crowds whose members hold together by kinship: {@link troupe.crowd.CrowdEngine} is the task, {@code
 * ground} says where an agent can stand and which way leads to its goal, {@code flock} moves the agents. At no frame
 * do two agents overlap or does one stand in an obstacle; the same scene and seed give the same frames on any number
 * of threads. Source: Crowd, all of it; Reynolds 1987; what is not in them is listed in {@code docs/crowd.md}.
 */
package troupe.crowd;
