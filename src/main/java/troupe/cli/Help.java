package troupe.cli;

import java.io.PrintStream;
import java.util.List;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.Option;

/** Prints the help, made from what the commands declare. */
final class Help {
    private static final int COLUMN = 26;

    private Help() {}

    /** Prints what the program is and its commands. */
    static void all(List<Command> commands, PrintStream out) {
        out.println("Troupe plans how digital actors move.");
        out.println();
        out.println("  troupe                    open the studio");
        for (Command command : commands) {
            row(command.name(), command.summary(), out);
        }
        out.println();
        out.println("troupe COMMAND --help tells more. Results go to standard output, messages to standard error.");
        out.println("troupe --version tells the version.");
        out.println("Exit code: 0 success, 1 no solution or failed check, 2 bad use, 3 bad input or output,");
        out.println("130 ended by Ctrl-C.");
    }

    /** Prints the help of one command. */
    static void one(Command command, PrintStream out) {
        out.println("usage: troupe " + command.name() + " " + command.usage());
        out.println();
        out.println("  " + command.summary());
        if (!command.options().isEmpty()) {
            out.println();
        }
        for (Option option : command.options()) {
            row(option.takesValue() ? option.name() + " " + option.value() : option.name(), option.text(), out);
        }
        if (!command.notes().isEmpty()) {
            out.println();
        }
        for (String note : command.notes()) {
            out.println("  " + note);
        }
    }

    private static void row(String left, String right, PrintStream out) {
        if (left.length() > COLUMN - 2) {
            out.println("  " + left);
            out.println(" ".repeat(2 + COLUMN) + right);
        } else {
            out.println("  " + left + " ".repeat(COLUMN - left.length()) + right);
        }
    }
}
