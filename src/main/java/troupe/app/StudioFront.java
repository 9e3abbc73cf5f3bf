package troupe.app;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import troupe.scene.xml.SceneException;
import troupe.work.Window;

/** Lets the studio be found as the program's window. */
public final class StudioFront implements Window {
    private static final Path SOCKETS = Path.of("/tmp/.X11-unix");

    /** Makes the front; nothing is opened yet. */
    public StudioFront() {}

    /** {@inheritDoc} Where there is none, the process draws without a display from now on. */
    @Override
    public boolean available() {
        String display = System.getenv("DISPLAY");
        if (display != null && !display.isEmpty() && !XDisplay.answers(display, SOCKETS)) {
            System.setProperty("java.awt.headless", "true");
        }
        if (GraphicsEnvironment.isHeadless()) {
            return false;
        }
        try {
            return GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | LinkageError e) {
            // the display does not let this process in, or this Java has no window toolkit
            return false;
        }
    }

    @Override
    public void open(Optional<Path> scene) throws SceneException, IOException {
        Studio.open(scene);
    }
}
