package troupe.exchange.picture;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.StreamExporter;
import troupe.run.Run;

/** Writes one instant as a PNG picture. */
public final class ImageExport implements StreamExporter {

    /** Makes the exporter. */
    public ImageExport() {}

    @Override
    public String name() {
        return "png";
    }

    @Override
    public String extension() {
        return "png";
    }

    @Override
    public String about() {
        return "a picture of one instant";
    }

    @Override
    public void write(Run run, ExportSettings settings, OutputStream out) throws IOException, ExchangeException {
        settings.proceed();
        write(settings.picture(run).image(settings.width(), settings.density()), out);
    }

    /** Writes an image as PNG; the stream stays open. */
    public static void write(BufferedImage image, OutputStream out) throws IOException {
        try (MemoryCacheImageOutputStream sink = new MemoryCacheImageOutputStream(out)) {
            if (!ImageIO.write(image, "png", sink)) {
                throw new IOException("this Java cannot write PNG images");
            }
        }
    }
}
