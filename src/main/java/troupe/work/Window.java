package troupe.work;

import java.nio.file.Path;
import java.util.Optional;

/** Opens the program's window. Found by {@link java.util.ServiceLoader}, so that a front needs no other front. */
public interface Window {

    /** Tells whether there is a display to open it on. */
    boolean available();

    /** Opens the window with a scene or run, or the start scene, and returns at once. */
    void open(Optional<Path> file);
}
