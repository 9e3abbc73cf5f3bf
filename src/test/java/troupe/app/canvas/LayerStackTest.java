package troupe.app.canvas;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LayerStackTest {
    private static final int SIZE = 40;
    private final int[] stamps = new int[4];
    private final List<LayerStack.Layer> layers = new ArrayList<>();

    LayerStackTest() {
        for (int i = 0; i < stamps.length; i++) {
            int layer = i;
            layers.add(new LayerStack.Layer() {
                @Override
                public Object stamp() {
                    return stamps[layer];
                }

                @Override
                public void paint(Graphics2D g) {
                    g.setColor(new Color(60 * layer, 31 * stamps[layer] % 256, 200, 128));
                    g.fillRect(4 * layer, 3 * layer, 14, 11 + stamps[layer] % 7);
                }
            });
        }
    }

    private static int[] paint(LayerStack stack, double scale, Object common) {
        return paint(stack, scale, common, false);
    }

    private static int[] paint(LayerStack stack, double scale, Object common, boolean inMemory) {
        int pixels = (int) (SIZE * scale);
        BufferedImage image = new BufferedImage(pixels, pixels, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
        stack.paint(g, SIZE, SIZE, Color.WHITE, common, inMemory);
        g.dispose();
        return image.getRGB(0, 0, pixels, pixels, null, 0, pixels);
    }

    @Test
    void paintsOnlyFromTheLowestChangeUp() {
        LayerStack stack = new LayerStack(layers);
        paint(stack, 1, "");
        stamps[3]++;
        paint(stack, 1, "");
        stamps[3]++;
        paint(stack, 1, "");
        assertEquals(1, stack.paintedLayers());
        paint(stack, 1, "");
        assertEquals(1, stack.paintedLayers());
        stamps[2]++;
        paint(stack, 1, "");
        stamps[2]++;
        paint(stack, 1, "");
        assertEquals(2, stack.paintedLayers());
        paint(stack, 1, "other view");
        assertEquals(4, stack.paintedLayers());
    }

    @Test
    void whatWasPaintedInMemoryIsShownAgainWhileNothingChanges() {
        LayerStack stack = new LayerStack(layers);
        int[] first = paint(stack, 1, "", true);
        assertEquals(4, stack.paintedLayers());
        assertArrayEquals(first, paint(stack, 1, "", true));
        assertEquals(0, stack.paintedLayers());
        stamps[3]++;
        int[] other = paint(stack, 1, "", false);
        // the picture in memory is an older one now
        assertArrayEquals(other, paint(stack, 1, "", true));
        assertEquals(1, stack.paintedLayers());
    }

    @Test
    void keptLayersShowWhatPaintingAllWouldShow() {
        long seed = Long.getLong("seed", 5);
        Random random = new Random(seed);
        LayerStack stack = new LayerStack(layers);
        for (int i = 0; i < 400; i++) {
            if (random.nextInt(4) > 0) {
                stamps[random.nextInt(stamps.length)]++;
            }
            double scale = i % 50 < 25 ? 1 : 2;
            Object view = i / 40;
            assertArrayEquals(
                    paint(new LayerStack(layers), scale, view),
                    paint(stack, scale, view, random.nextBoolean()),
                    "step " + i + " seed " + seed);
        }
    }

    @Test
    void printsWhatItPaints() {
        LayerStack stack = new LayerStack(layers);
        int[] painted = paint(stack, 1, "");
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        stack.print(g, SIZE, SIZE, Color.WHITE);
        g.dispose();
        assertArrayEquals(painted, image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE));
    }
}
