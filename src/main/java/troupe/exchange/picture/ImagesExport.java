package troupe.exchange.picture;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.exchange.format.Instants;
import troupe.paint.picture.Animation;
import troupe.run.Run;
import troupe.scene.xml.AtomicFile;

/** Writes all of a run as numbered PNG pictures: {@code NAME-00000.png}, {@code NAME-00001.png}, … */
public final class ImagesExport implements Exporter {

    /** Makes the exporter. */
    public ImagesExport() {}

    @Override
    public String name() {
        return "pngs";
    }

    @Override
    public String extension() {
        return "png";
    }

    @Override
    public String about() {
        return "numbered pictures of the whole run, NAME-00000.png and on, for films";
    }

    @Override
    public void write(Run run, ExportSettings settings, Path target) throws IOException, ExchangeException {
        double[] instants = Instants.of(run, settings);
        Animation animation = new Animation(settings.picture(run), settings.width(), settings.density());
        int done = 0;
        try {
            for (double time : instants) {
                settings.proceed();
                AtomicFile.write(numbered(target, done), out -> ImageExport.write(animation.image(time), out));
                done++;
            }
        } catch (InterruptedIOException e) {
            // half a film is of no use
            for (int k = 0; k < done; k++) {
                Files.deleteIfExists(numbered(target, k));
            }
            throw e;
        }
    }

    /** Returns the path of picture {@code k}: the number goes before the ending. */
    static Path numbered(Path target, int k) {
        String file = String.valueOf(target.getFileName());
        String stem = file.toLowerCase(Locale.ROOT).endsWith(".png") ? file.substring(0, file.length() - 4) : file;
        return target.resolveSibling(String.format(Locale.ROOT, "%s-%05d.png", stem, k));
    }
}
