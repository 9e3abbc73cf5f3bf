package troupe.paint;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import troupe.grid.GridFrame;
import troupe.run.Overlay;

/**
 * Paints a field as an image of one sample for each pixel of the device, so that cells keep sharp edges
 * and patterns keep their size at any zoom. Cost O(pixels shown), whatever the number of cells.
 */
final class FieldRaster {
    private static final double CONTINUOUS_OPACITY = 0.85;
    private static final int MAX_SIDE = 8_192;

    private final Overlay.Field field;
    private final Theme theme;

    /** Makes the raster of a field. */
    FieldRaster(Overlay.Field field, Theme theme) {
        this.field = field;
        this.theme = theme;
    }

    /** Paints the part of the field that lies in the clip. */
    void paint(Graphics2D g, Viewport view) {
        GridFrame frame = field.frame();
        Rectangle2D whole = new Rectangle2D.Double(
                view.px(frame.originX()),
                view.py(frame.originY() + frame.rows() * frame.cell()),
                frame.cols() * frame.cell() * view.scale(),
                frame.rows() * frame.cell() * view.scale());
        Rectangle clip = g.getClipBounds();
        Rectangle seen = (clip == null ? whole : whole.createIntersection(clip)).getBounds();
        if (seen.isEmpty()) {
            return;
        }
        double density = Math.max(1, Math.abs(g.getTransform().getScaleX()));
        density = Math.min(density, (double) MAX_SIDE / Math.max(seen.width, seen.height));
        int width = Math.max(1, (int) Math.round(seen.width * density));
        int height = Math.max(1, (int) Math.round(seen.height * density));
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        int[] pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        int[] cols = new int[width];
        for (int x = 0; x < width; x++) {
            cols[x] = frame.colAt(view.x(seen.x + (x + 0.5) * seen.width / width));
        }
        Sampler sampler = sampler(density);
        for (int y = 0; y < height; y++) {
            int row = frame.rowAt(view.y(seen.y + (y + 0.5) * seen.height / height));
            for (int x = 0; x < width && row >= 0 && row < frame.rows(); x++) {
                if (cols[x] >= 0 && cols[x] < frame.cols()) {
                    float value = field.values()[frame.index(cols[x], row)];
                    pixels[y * width + x] = Float.isNaN(value) ? 0 : sampler.argb(value, x, y);
                }
            }
        }
        AffineTransform place =
                new AffineTransform((double) seen.width / width, 0, 0, (double) seen.height / height, seen.x, seen.y);
        g.drawImage(image, place, null);
    }

    /** Gives the colour of a value at a pixel. */
    private interface Sampler {
        int argb(float value, int x, int y);
    }

    private Sampler sampler(double density) {
        if (field.scale() instanceof Overlay.Continuous scale) {
            ColourMap map = new ColourMap(theme);
            double span = scale.max() > scale.min() ? scale.max() - scale.min() : 1;
            int alpha = (int) Math.round(255 * CONTINUOUS_OPACITY) << 24;
            return (value, x, y) ->
                    Float.isInfinite(value) ? 0 : alpha | map.argb((value - scale.min()) / span) & 0xffffff;
        }
        CategoryLook[] looks = CategoryLook.of(((Overlay.Categories) field.scale()).words(), theme);
        return (value, x, y) -> value >= 0 && value < looks.length
                ? looks[(int) value].argb((int) (x / density), (int) (y / density))
                : 0;
    }
}
