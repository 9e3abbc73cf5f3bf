package troupe.exchange.format;

import java.io.IOException;
import java.nio.file.Path;
import troupe.scene.Scene;

/** Reads a scene from the file of another program. */
public interface Importer {

    /** Returns the name by which the format is chosen, for example {@code movingai}. */
    String name();

    /** Returns the usual ending of its files, without the dot. */
    String extension();

    /** Returns what it is for, in one line. */
    String about();

    /**
     * Reads a file.
     *
     * @throws ExchangeException if it is not a whole file of the format, or too large
     */
    Scene read(Path file) throws IOException, ExchangeException;
}
