package troupe.cli.terminal;

import java.io.IOException;
import java.util.List;
import troupe.exchange.format.ExchangeException;
import troupe.run.file.RunException;
import troupe.scene.xml.SceneException;

/** One command of the program. Commands keep no state between runs. */
public interface Command {

    /** Returns the word that calls it. */
    String name();

    /** Returns what follows the word: {@code SCENE [--task ID]}. */
    String usage();

    /** Returns what it does, one line. */
    String summary();

    /** Returns its options, {@code --help} apart. */
    List<Option> options();

    /** Returns more lines of help, one string each; may be none. */
    default List<String> notes() {
        return List.of();
    }

    /**
     * Does the work and returns the exit code: 0, or 1 for no solution or a failed check.
     *
     * @throws UsageException for bad use (exit code 2)
     * @throws SceneException for a bad scene (exit code 3, as the following)
     * @throws RunException for a bad run file
     * @throws ExchangeException for a bad file of another format
     * @throws IOException if a file cannot be read or written
     */
    int run(Arguments arguments, Terminal terminal)
            throws UsageException, SceneException, RunException, ExchangeException, IOException;
}
