package troupe.scene;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;

/** Reads scenes from texts, and finds the sample scenes. */
public final class SceneTexts {
    private SceneTexts() {}

    /** Returns the sample scenes of the unified planner, in the order of their names. */
    public static Stream<Path> samples() throws IOException {
        return Files.list(Path.of("scenes/unified"))
                .filter(p -> p.toString().endsWith(".xml"))
                .sorted();
    }

    /** Reads a scene from the text of its file. */
    public static Scene read(String text) throws SceneException, IOException {
        return SceneXml.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "test.xml")
                .scene();
    }
}
