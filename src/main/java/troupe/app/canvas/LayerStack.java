package troupe.app.canvas;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Paints layers one over the other and keeps a picture of those below the lowest one that changed, so
 * that playing a run or dragging a thing paints only what moves. Where that is much, it is painted in memory and goes to
 * the screen at once, and the same picture again where nothing changed. A layer changes when its stamp does.
 */
final class LayerStack {

    /** One layer: a stamp of everything its painting depends on, and the painting. */
    interface Layer {

        /** Returns what the painting depends on; equal stamps mean equal pictures. */
        Object stamp();

        /** Paints the layer. */
        void paint(Graphics2D g);
    }

    private final List<Layer> layers;
    private List<Object> stamps = List.of();
    private RenderingHints hints;
    private BufferedImage below;
    private BufferedImage all;
    /** Whether the picture of all layers is that of the last stamps. */
    private boolean composed;

    private int kept;
    private Object ground;
    private int painted;

    LayerStack(List<Layer> layers) {
        this.layers = List.copyOf(layers);
    }

    /** Returns how many layers were painted anew the last time. */
    int paintedLayers() {
        return painted;
    }

    /**
     * Paints all layers on a background.
     *
     * @param common what every layer depends on, such as the viewport
     * @param inMemory whether the changing layers, too, are painted in memory: where they are of pixels rather than of
     *     shapes, or change much
     */
    void paint(Graphics2D g, int width, int height, Color background, Object common, boolean inMemory) {
        AffineTransform scale = g.getTransform();
        double sx = scale.getScaleX();
        double sy = scale.getScaleY();
        List<Object> now = new ArrayList<>();
        layers.forEach(layer -> now.add(layer.stamp()));
        Object groundNow = List.of(width, height, sx, sy, background, common);
        boolean whole = !groundNow.equals(ground);
        int keep = whole ? 0 : lowestChange(now);
        boolean same = composed && !whole && now.equals(stamps);
        ground = groundNow;
        stamps = now;
        painted = 0;
        composed = inMemory;
        if (inMemory && same) {
            show(all, g);
            return;
        }
        int deviceWidth = (int) Math.ceil(width * sx);
        int deviceHeight = (int) Math.ceil(height * sy);
        hints = g.getRenderingHints();
        if (keep > 0) {
            keepLayers(keep, deviceWidth, deviceHeight, scale, background);
        } else {
            kept = 0;
        }
        if (inMemory) {
            all = room(all, deviceWidth, deviceHeight);
            Graphics2D memory = all.createGraphics();
            memory.setRenderingHints(hints);
            memory.clipRect(0, 0, deviceWidth, deviceHeight);
            memory.scale(sx, sy);
            paintFrom(keep, memory, width, height, background);
            memory.dispose();
            show(all, g);
        } else {
            paintFrom(keep, g, width, height, background);
        }
    }

    /** Paints what is kept of the layers below {@code keep}, and the others over it. */
    private void paintFrom(int keep, Graphics2D g, int width, int height, Color background) {
        if (keep > 0) {
            show(below, g);
        } else {
            g.setColor(background);
            g.fillRect(0, 0, width, height);
        }
        for (int i = keep; i < layers.size(); i++) {
            layers.get(i).paint(g);
            painted++;
        }
    }

    /** Paints a picture that has the pixels of the device. */
    private static void show(BufferedImage image, Graphics2D g) {
        AffineTransform scale = g.getTransform();
        Graphics2D device = (Graphics2D) g.create();
        device.setTransform(AffineTransform.getTranslateInstance(scale.getTranslateX(), scale.getTranslateY()));
        device.drawImage(image, 0, 0, null);
        device.dispose();
    }

    /** Paints all layers on a background, each directly: for printers, and whoever wants to see what is painted. */
    void print(Graphics2D g, int width, int height, Color background) {
        g.setColor(background);
        g.fillRect(0, 0, width, height);
        layers.forEach(layer -> layer.paint(g));
    }

    /** Returns a picture of a size, the one given if it fits. */
    private static BufferedImage room(BufferedImage image, int width, int height) {
        return image != null && image.getWidth() == width && image.getHeight() == height
                ? image
                : new BufferedImage(Math.max(1, width), Math.max(1, height), BufferedImage.TYPE_INT_RGB);
    }

    /** Returns the lowest layer that changed, or as many as are kept already if none did. */
    private int lowestChange(List<Object> now) {
        for (int i = 0; i < now.size(); i++) {
            if (i >= stamps.size() || !Objects.equals(now.get(i), stamps.get(i))) {
                return i;
            }
        }
        return Math.max(kept, layers.size() - 1);
    }

    private void keepLayers(int keep, int width, int height, AffineTransform scale, Color background) {
        BufferedImage before = below;
        below = room(below, width, height);
        boolean fits = below == before;
        if (!fits || kept > keep || kept == 0) {
            kept = 0;
        }
        Graphics2D g = below.createGraphics();
        g.setRenderingHints(hints);
        if (kept == 0) {
            g.setColor(background);
            g.fillRect(0, 0, width, height);
        }
        g.scale(scale.getScaleX(), scale.getScaleY());
        for (; kept < keep; kept++) {
            layers.get(kept).paint(g);
            painted++;
        }
        g.dispose();
    }
}
