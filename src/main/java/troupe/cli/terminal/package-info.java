/**
 * Holds what every command meets: the words typed, where results and messages go, progress, and the exit code.
 */
package troupe.cli.terminal;
