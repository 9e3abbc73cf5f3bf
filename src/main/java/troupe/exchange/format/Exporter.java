package troupe.exchange.format;

import java.io.IOException;
import java.nio.file.Path;
import troupe.run.Run;

/** Writes a run in one format. Immutable; serves any thread. */
public interface Exporter {

    /** Returns the name by which the format is chosen, for example {@code csv}. */
    String name();

    /** Returns the usual ending of its files, without the dot. */
    String extension();

    /** Returns what it is for, in one line. */
    String about();

    /**
     * Writes the run to a file, or to files beside it, each whole or not at all.
     *
     * @throws ExchangeException if the format cannot hold the run
     */
    void write(Run run, ExportSettings settings, Path target) throws IOException, ExchangeException;
}
