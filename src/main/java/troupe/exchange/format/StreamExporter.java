package troupe.exchange.format;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import troupe.run.Run;
import troupe.scene.xml.AtomicFile;

/** Writes a run in a format of one file, so that it can go to a stream too. */
public interface StreamExporter extends Exporter {

    /**
     * Writes the run to a stream, which stays open. Nothing is written if the format cannot hold the run.
     *
     * @throws ExchangeException if the format cannot hold the run
     */
    void write(Run run, ExportSettings settings, OutputStream out) throws IOException, ExchangeException;

    @Override
    default void write(Run run, ExportSettings settings, Path target) throws IOException, ExchangeException {
        AtomicFile.write(target, out -> write(run, settings, out));
    }
}
