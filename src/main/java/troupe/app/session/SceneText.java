package troupe.app.session;

import java.io.IOException;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/** Writes and reads scenes as texts of the scene format. Called on a background thread. */
public interface SceneText {

    /** Returns a scene as text. */
    String write(Scene scene);

    /**
     * Reads a scene.
     *
     * @throws SceneException if the text is not one
     * @throws IOException if it cannot be read
     */
    Scene read(String text) throws SceneException, IOException;
}
