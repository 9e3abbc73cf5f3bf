package troupe.cli.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;

/**
 * Holds a file to read; for {@code -} a copy of standard input, deleted when closed, because runs are read from
 * any place of a file.
 *
 * @param path what to read
 * @param copied whether it is a copy in a folder of its own
 */
record InputFile(Path path, boolean copied) implements AutoCloseable {

    /** Finds what a word of the command line names. */
    static InputFile of(String word, Terminal terminal) throws UsageException, IOException {
        if (!word.equals("-")) {
            return new InputFile(Arguments.input(word), false);
        }
        Path folder = Files.createTempDirectory("troupe");
        // the name is what messages say
        InputFile file = new InputFile(folder.resolve("standard input"), true);
        try {
            Files.copy(terminal.in(), file.path());
            return file;
        } catch (IOException e) {
            file.close();
            throw e;
        }
    }

    @Override
    public void close() throws IOException {
        if (copied) {
            Files.deleteIfExists(path);
            Files.delete(path.getParent());
        }
    }
}
