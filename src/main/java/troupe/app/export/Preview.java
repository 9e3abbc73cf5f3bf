package troupe.app.export;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import troupe.app.look.Failures;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.exchange.format.StreamExporter;
import troupe.run.Run;

/**
 * Shows what an export will be: a picture, or the first lines of its text. Immutable.
 *
 * @param image a picture of the instant, for formats that are pictures
 * @param text the first lines, for others; or why there is nothing to be seen
 * @param wrong whether the text says that
 */
record Preview(Optional<BufferedImage> image, String text, boolean wrong) {
    /** The formats that are pictures. */
    static final Set<String> PICTURES = Set.of("svg", "png", "pngs", "gif");

    private static final int WIDTH = 640;
    private static final int MOST_BYTES = 6_000;

    /** Makes the preview of an export. Takes as long as one picture, or as the first lines. */
    static Preview of(Exporter exporter, Run run, ExportSettings settings) {
        try {
            if (PICTURES.contains(exporter.name())) {
                ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                StreamExporter png = (StreamExporter) Formats.exporter("png");
                png.write(run, settings.wide(WIDTH), bytes);
                return new Preview(
                        Optional.ofNullable(ImageIO.read(new ByteArrayInputStream(bytes.toByteArray()))), "", false);
            }
            return new Preview(Optional.empty(), lines(exporter, run, settings), false);
        } catch (IOException | ExchangeException e) {
            return new Preview(Optional.empty(), Failures.line(Path.of(""), e), true);
        }
    }

    private static String lines(Exporter exporter, Run run, ExportSettings settings)
            throws IOException, ExchangeException {
        if (exporter instanceof StreamExporter stream) {
            Head head = new Head();
            try {
                stream.write(run, settings, head);
            } catch (Enough e) {
                return head.text() + "…";
            }
            return head.text();
        }
        Path folder = Files.createTempDirectory("troupe");
        try {
            exporter.write(run, settings, folder.resolve("run." + exporter.extension()));
            StringBuilder text = new StringBuilder();
            for (Path file : files(folder)) {
                String content = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
                text.append(file.getFileName())
                        .append('\n')
                        .append(content, 0, Math.min(content.length(), MOST_BYTES / 4))
                        .append("\n…\n");
            }
            return text.toString();
        } finally {
            for (Path file : files(folder)) {
                Files.delete(file);
            }
            Files.delete(folder);
        }
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.sorted().toList();
        }
    }

    /** Ends an export whose first lines are there. */
    private static final class Enough extends IOException {
        private Enough() {
            super("enough");
        }
    }

    /** Keeps the first bytes. */
    private static final class Head extends OutputStream {
        private final ByteArrayOutputStream kept = new ByteArrayOutputStream();

        @Override
        public void write(int value) throws IOException {
            if (kept.size() >= MOST_BYTES) {
                throw new Enough();
            }
            kept.write(value);
        }

        String text() {
            return kept.toString(StandardCharsets.UTF_8);
        }
    }
}
