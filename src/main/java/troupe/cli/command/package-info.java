/**
 * Holds the commands, one class each, and what several of them share: what they read, the tables and pictures
 * they write.
 */
package troupe.cli.command;
