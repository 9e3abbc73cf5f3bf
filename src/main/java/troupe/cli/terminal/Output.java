package troupe.cli.terminal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import troupe.scene.xml.AtomicFile;

/** Sends text to the file of {@code -o}, or to standard output for {@code -} and without {@code -o}. */
public final class Output {
    private Output() {}

    /** What writes the text. */
    @FunctionalInterface
    public interface Text {
        void writeTo(PrintStream out) throws IOException;
    }

    /** Writes a text to the file of {@code -o}, or to standard output. */
    public static void write(Arguments arguments, Terminal terminal, Text text) throws UsageException, IOException {
        String file = arguments.value("-o").orElse("-");
        if (file.equals("-")) {
            text.writeTo(terminal.out());
            terminal.out().flush();
            return;
        }
        AtomicFile.write(Arguments.path(file), stream -> {
            PrintStream out = new PrintStream(stream, false, StandardCharsets.UTF_8);
            text.writeTo(out);
            out.flush();
            if (out.checkError()) {
                throw new IOException(file + " cannot be written");
            }
        });
    }
}
