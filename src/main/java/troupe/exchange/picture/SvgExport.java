package troupe.exchange.picture;

import java.awt.Dimension;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.StreamExporter;
import troupe.paint.picture.Picture;
import troupe.run.Run;

/** Writes one instant as an SVG drawing: lines and text stay sharp at any size, fields become images. */
public final class SvgExport implements StreamExporter {
    private static final double UNITS = 2;

    /** Makes the exporter. */
    public SvgExport() {}

    @Override
    public String name() {
        return "svg";
    }

    @Override
    public String extension() {
        return "svg";
    }

    @Override
    public String about() {
        return "a drawing of one instant, for papers and slides";
    }

    @Override
    public void write(Run run, ExportSettings settings, OutputStream out) throws IOException, ExchangeException {
        settings.proceed();
        out.write(document(settings.picture(run), settings.width()).getBytes(StandardCharsets.UTF_8));
    }

    /** Returns a picture of the given width in pixels as the text of an SVG document. */
    public static String document(Picture picture, int width) {
        SvgGraphics g = new SvgGraphics();
        g.scale(UNITS, UNITS);
        picture.paint(g, width);
        Dimension size = picture.size(width);
        String title = picture.scene().title();
        return g.document(title.isBlank() ? "Troupe" : title, size.width, size.height, UNITS);
    }
}
