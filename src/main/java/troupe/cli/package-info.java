/**
 * Holds the command line: a thin front over {@code work}; its commands lie below. Results go to standard output, messages to
 * standard error; the exit code is 0 for success, 1 for no solution or a failed check, 2 for bad use, 3 for
 * bad input, 4 for a fault of the program itself. Uses everything but {@code app}.
 */
package troupe.cli;
