package troupe.app.session;

import java.io.IOException;
import java.nio.file.Path;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/** Reads and writes scene files. Called on a background thread; tests put guards around it. */
public interface SceneFiles {

    /**
     * Reads a scene.
     *
     * @throws SceneException if the file is not a scene
     * @throws IOException if it cannot be read
     */
    Scene read(Path file) throws SceneException, IOException;

    /** Writes a scene; at any crash the old file or the new one is there. */
    void write(Scene scene, Path file) throws IOException;
}
