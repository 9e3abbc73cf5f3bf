package troupe.scene.xml;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import troupe.scene.Scene;

/**
 * Reads and writes scene files ({@code urn:troupe:scene:1}). What {@link #write(Scene)} wrote reads back
 * equal and is written again byte for byte. Reading takes O(size) time and memory; files of more than
 * {@value #MAX_BYTES} bytes are refused.
 */
public final class SceneXml {
    /** The namespace of scene files. */
    public static final String NAMESPACE = "urn:troupe:scene:1";

    /** The largest file that is read, in bytes. */
    public static final int MAX_BYTES = 64 << 20;

    private SceneXml() {}

    /**
     * Reads a scene file.
     *
     * @throws SceneException if it is not a scene file, with line and column of each mistake
     * @throws IOException if it cannot be read
     */
    public static SceneSource read(Path file) throws SceneException, IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return new SceneReader(
                            file.toString(), Optional.of(file.toAbsolutePath().getParent()))
                    .read(bytes(in, file.toString()));
        }
    }

    /**
     * Reads a scene from a stream, which stays open. It cannot name files beside it.
     *
     * @param name what to call the source in messages
     * @throws SceneException if it is not a scene, with line and column of each mistake
     * @throws IOException if it cannot be read
     */
    public static SceneSource read(InputStream in, String name) throws SceneException, IOException {
        return new SceneReader(name, Optional.empty()).read(bytes(in, name));
    }

    private static byte[] bytes(InputStream in, String name) throws SceneException, IOException {
        byte[] bytes = in.readNBytes(MAX_BYTES + 1);
        if (bytes.length > MAX_BYTES) {
            throw new SceneException(name, 0, "more than " + MAX_BYTES + " bytes", "split the scene");
        }
        return bytes;
    }

    /**
     * Returns a scene as the text of a scene file, lines ended by a line feed.
     *
     * @throws IllegalArgumentException if a text holds a character that XML cannot; the checks name it before
     */
    public static String write(Scene scene) {
        return new SceneWriter().write(scene);
    }

    /**
     * Writes a scene file as a whole: at any moment the old file or the new one is there.
     *
     * @throws IOException if it cannot be written; then the old file is untouched
     */
    public static void write(Scene scene, Path file) throws IOException {
        byte[] text = write(scene).getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(file, out -> out.write(text));
    }
}
