package troupe.app;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import troupe.scene.SceneException;
import troupe.work.Window;

/** Lets the studio be found as the program's window. */
public final class StudioFront implements Window {

    /** Makes the front; nothing is opened yet. */
    public StudioFront() {}

    @Override
    public boolean available() {
        if (GraphicsEnvironment.isHeadless()) {
            return false;
        }
        try {
            return GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | LinkageError e) {
            // a display is named, but it does not answer, or this Java has no window toolkit
            return false;
        }
    }

    @Override
    public void open(Optional<Path> scene) throws SceneException, IOException {
        Studio.open(scene);
    }
}
