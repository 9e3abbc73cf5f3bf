package troupe.app.session;

import java.io.IOException;
import java.nio.file.Path;
import troupe.exchange.format.ExchangeException;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/** Reads and writes scene files, and reads those of other programs. Called on a background thread; tests put guards around it. */
public interface SceneFiles {

    /**
     * Reads a scene.
     *
     * @throws SceneException if the file is not a scene
     * @throws IOException if it cannot be read
     */
    Scene read(Path file) throws SceneException, IOException;

    /**
     * Makes a scene of another program's file.
     *
     * @throws ExchangeException if its ending names no format, or it is not a whole file of that format
     * @throws IOException if it cannot be read
     */
    Scene convert(Path file) throws ExchangeException, IOException;

    /** Writes a scene; at any crash the old file or the new one is there. */
    void write(Scene scene, Path file) throws IOException;
}
