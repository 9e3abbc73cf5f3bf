package troupe.app;

import java.awt.GraphicsEnvironment;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** Opens the real window on a copy of the courtyard before each test, and closes it after; skips without a display. */
abstract class RobotTest {
    @TempDir
    Path folder;

    StudioFixture studio;

    @BeforeEach
    void open() throws Exception {
        Assumptions.assumeFalse(GraphicsEnvironment.isHeadless(), "skipped: there is no display");
        begin();
    }

    /** Opens the studio that the tests work; where each test opens its own, does something else. */
    void begin() throws Exception {
        studio = new StudioFixture(folder);
    }

    @AfterEach
    void close() {
        if (studio != null) {
            studio.close();
        }
    }

    /** Performs a command of the window by its name. */
    void perform(String command) {
        OnEventThread.run(() -> studio.window().commands().get(command).perform());
    }
}
