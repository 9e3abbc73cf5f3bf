package troupe.exchange.format;

import java.awt.Dimension;
import java.io.InterruptedIOException;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import troupe.paint.Theme;
import troupe.paint.picture.Picture;
import troupe.paint.solid.Camera;
import troupe.run.Run;
import troupe.run.view.Overlay;

/**
 * Says how a run is to be exported; a format takes what concerns it.
 *
 * @param time the instant of a single picture, in seconds from 0; later than the end means the end
 * @param width width of a picture in pixels, {@value Picture#MIN_WIDTH} to {@value Picture#MAX_WIDTH}
 * @param density pixels of the image for each pixel of the layout, from 1 to 4
 * @param rate pictures for each second of an animation, above 0 and at most 50
 * @param overlays views to lay over the scene
 * @param angle from where pictures show the scene in three dimensions, without overlays; empty for the plan view
 * @param stopped tells whether the export is to end early and leave nothing
 */
public record ExportSettings(
        double time,
        int width,
        double density,
        double rate,
        Theme theme,
        List<Overlay> overlays,
        Optional<Camera.Angle> angle,
        BooleanSupplier stopped) {

    /** The start of the run, 900 pixels wide, light, 10 pictures a second. */
    public static final ExportSettings DEFAULT =
            new ExportSettings(0, 900, 1, 10, Theme.LIGHT, List.of(), Optional.empty(), () -> false);

    /**
     * Checks the numbers and copies the overlays.
     *
     * @throws IllegalArgumentException naming the value and its range
     */
    public ExportSettings {
        require(time >= 0 && time < 1e9, "time=" + time + "; needs seconds from 0");
        require(
                width >= Picture.MIN_WIDTH && width <= Picture.MAX_WIDTH,
                "width=" + width + "; needs " + Picture.MIN_WIDTH + " to " + Picture.MAX_WIDTH + " pixels");
        require(density >= 1 && density <= 4, "density=" + density + "; needs 1 to 4");
        require(rate > 0 && rate <= 50, "rate=" + rate + "; needs above 0, at most 50 pictures a second");
        overlays = List.copyOf(overlays);
    }

    private static void require(boolean right, String wrong) {
        if (!right) {
            throw new IllegalArgumentException(wrong);
        }
    }

    /** Returns these settings for another instant. */
    public ExportSettings at(double seconds) {
        return new ExportSettings(seconds, width, density, rate, theme, overlays, angle, stopped);
    }

    /** Returns these settings for another width in pixels. */
    public ExportSettings wide(int pixels) {
        return new ExportSettings(time, pixels, density, rate, theme, overlays, angle, stopped);
    }

    /** Returns these settings for another theme. */
    public ExportSettings in(Theme other) {
        return new ExportSettings(time, width, density, rate, other, overlays, angle, stopped);
    }

    /** Returns these settings for another number of pictures a second. */
    public ExportSettings every(double perSecond) {
        return new ExportSettings(time, width, density, perSecond, theme, overlays, angle, stopped);
    }

    /** Returns these settings with other overlays. */
    public ExportSettings with(List<Overlay> others) {
        return new ExportSettings(time, width, density, rate, theme, others, angle, stopped);
    }

    /** Returns these settings for pictures in three dimensions, seen from an angle. */
    public ExportSettings from(Camera.Angle seen) {
        return new ExportSettings(time, width, density, rate, theme, overlays, Optional.of(seen), stopped);
    }

    /** Returns these settings for an export that ends as soon as {@code ended} tells so; any thread may set it. */
    public ExportSettings until(BooleanSupplier ended) {
        return new ExportSettings(time, width, density, rate, theme, overlays, angle, ended);
    }

    /**
     * Goes on, unless the export is to end; an exporter asks before each picture.
     *
     * @throws InterruptedIOException if it is to end
     */
    public void proceed() throws InterruptedIOException {
        if (stopped.getAsBoolean()) {
            throw new InterruptedIOException("interrupted; nothing was written");
        }
    }

    /**
     * Returns the picture of a run at the instant of these settings.
     *
     * @throws ExchangeException if it would have more pixels than an image may have
     */
    public Picture picture(Run run) throws ExchangeException {
        Picture picture = Picture.of(run, Math.min(time, run.frames().duration()))
                .with(theme)
                .with(overlays);
        // a field fills the scene only where it is the one thing to look at
        boolean several = overlays.stream().map(Overlay::key).distinct().count() > 1;
        picture = several ? picture.outlined() : picture;
        picture = angle.isPresent() ? picture.solid(angle.get()) : picture;
        Dimension size = picture.size(width);
        if (size.width * density * size.height * density > Picture.MAX_PIXELS) {
            throw new ExchangeException(
                    "the picture",
                    0,
                    0,
                    size.width + " x " + size.height + " pixels, " + density + " times as large",
                    "lower the width or the density until it has at most " + Picture.MAX_PIXELS);
        }
        return picture;
    }
}
