package troupe.work;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import troupe.scene.xml.SceneException;

/** Opens the program's window. Found by {@link java.util.ServiceLoader}, so that a front needs no other front. */
public interface Window {

    /** Tells whether there is a display to open it on. */
    boolean available();

    /**
     * Opens the window with a scene, or with the start scene, and returns; the program lives on until it is
     * closed.
     *
     * @throws SceneException if the file is not a scene
     * @throws IOException if it cannot be read
     */
    void open(Optional<Path> scene) throws SceneException, IOException;
}
