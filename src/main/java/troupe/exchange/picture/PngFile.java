package troupe.exchange.picture;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import troupe.paint.picture.Picture;
import troupe.paint.picture.StripPainter;
import troupe.scene.xml.AtomicFile;

/** Writes single pictures as PNG files, whole or not at all. */
public final class PngFile {
    private PngFile() {}

    /**
     * Writes a picture laid out for a width in pixels.
     *
     * @throws IOException if it cannot be written
     */
    public static void write(Picture picture, int width, Path file) throws IOException {
        write(picture.image(width), file);
    }

    /**
     * Writes strips of values over time, of a width in pixels.
     *
     * @throws IOException if they cannot be written
     */
    public static void write(StripPainter strips, int width, Path file) throws IOException {
        write(strips.image(width), file);
    }

    private static void write(BufferedImage image, Path file) throws IOException {
        AtomicFile.write(file, out -> {
            if (!ImageIO.write(image, "png", out)) {
                throw new IOException(file + " cannot be written");
            }
        });
    }
}
