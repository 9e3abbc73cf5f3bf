package troupe.cli.terminal;

import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.function.BooleanSupplier;

/**
 * Holds what a command speaks with.
 *
 * @param in standard input
 * @param out results
 * @param err messages
 * @param interactive whether a person watches {@code err}, so that a progress bar is of use
 * @param folder where a command that is not told a place leaves its files
 * @param interrupted tells whether the work is to end early
 */
public record Terminal(
        InputStream in,
        PrintStream out,
        PrintStream err,
        boolean interactive,
        Path folder,
        BooleanSupplier interrupted) {

    /** Makes the terminal of this process. */
    public static Terminal system(BooleanSupplier interrupted) {
        return new Terminal(
                System.in,
                new PrintStream(System.out, true, StandardCharsets.UTF_8),
                new PrintStream(System.err, true, StandardCharsets.UTF_8),
                System.console() != null,
                Path.of(""),
                interrupted);
    }

    /** Says one line to the person. */
    public void say(String message) {
        err.println("troupe: " + message);
    }
}
