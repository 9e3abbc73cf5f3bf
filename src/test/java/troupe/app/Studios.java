package troupe.app;

import java.io.IOException;
import java.nio.file.Path;
import troupe.app.session.SceneFiles;
import troupe.scene.Scene;

/** Holds parts of studios for tests. */
public final class Studios {
    private Studios() {}

    /** Files that are not there. */
    public static final SceneFiles NO_FILES = new SceneFiles() {
        @Override
        public Scene read(Path file) throws IOException {
            throw new IOException(file + ": not here");
        }

        @Override
        public Scene convert(Path file) throws IOException {
            throw new IOException(file + ": not here");
        }

        @Override
        public void write(Scene scene, Path file) throws IOException {
            throw new IOException(file + ": not here");
        }
    };
}
