/**
 * Holds the commands, one class each, and what several of them share in reading and planning.
 */
package troupe.cli.command;
