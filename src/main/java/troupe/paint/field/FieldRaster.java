package troupe.paint.field;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import troupe.grid.GridFrame;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.run.view.Overlay;

/**
 * Paints a field as an image of one sample for each pixel of the device, so that cells keep sharp edges
 * and patterns keep their size at any zoom. Cost O(pixels of the cells that have a value), however many there are.
 */
final class FieldRaster {
    private static final double CONTINUOUS_OPACITY = 0.85;
    private static final int MAX_SIDE = 8_192;

    private final Overlay.Field field;
    private final Theme theme;
    private final Rectangle2D bounds;

    /** Makes the raster of a field. Cost O(cells). */
    FieldRaster(Overlay.Field field, Theme theme) {
        this.field = field;
        this.theme = theme;
        this.bounds = bounds(field);
    }

    /** Returns the box in metres, y up, of the cells that have a value; empty if none has. */
    private static Rectangle2D bounds(Overlay.Field field) {
        GridFrame frame = field.frame();
        int left = frame.cols();
        int right = -1;
        int low = frame.rows();
        int high = -1;
        for (int i = 0; i < frame.size(); i++) {
            if (!Float.isNaN(field.values()[i])) {
                left = Math.min(left, frame.col(i));
                right = Math.max(right, frame.col(i));
                low = Math.min(low, frame.row(i));
                high = Math.max(high, frame.row(i));
            }
        }
        return new Rectangle2D.Double(
                frame.originX() + left * frame.cell(),
                frame.originY() + low * frame.cell(),
                Math.max(0, right + 1 - left) * frame.cell(),
                Math.max(0, high + 1 - low) * frame.cell());
    }

    /** Paints the part of the field that lies in the clip. */
    void paint(Graphics2D g, Viewport view) {
        GridFrame frame = field.frame();
        Rectangle2D whole = new Rectangle2D.Double(
                view.px(bounds.getMinX()),
                view.py(bounds.getMaxY()),
                bounds.getWidth() * view.scale(),
                bounds.getHeight() * view.scale());
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
            ColourMap map = ColourMap.of(field.key(), theme);
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
