package troupe.exchange.picture;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Chooses at most 256 colours for a few images by median cut over their colours in steps of eight, and
 * turns images to them. Deterministic.
 *
 * <p>Source: P. Heckbert, Color image quantization for frame buffer display, SIGGRAPH 1982. Deviation: the
 * box with the largest count times widest side is split next, which keeps thin lines' colours.
 */
public final class Palette {
    private static final int SIZE = 256;
    private static final int BUCKETS = 1 << 15;

    private final int[] colours;
    private final byte[] nearest = new byte[BUCKETS];
    private final boolean[] known = new boolean[BUCKETS];
    private final IndexColorModel model;

    /** Chooses the colours of the given images. */
    public Palette(BufferedImage... images) {
        long[] red = new long[BUCKETS];
        long[] green = new long[BUCKETS];
        long[] blue = new long[BUCKETS];
        int[] count = new int[BUCKETS];
        for (BufferedImage image : images) {
            for (int rgb : image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth())) {
                int k = bucket(rgb);
                count[k]++;
                red[k] += rgb >> 16 & 255;
                green[k] += rgb >> 8 & 255;
                blue[k] += rgb & 255;
            }
        }
        List<int[]> entries = new ArrayList<>();
        for (int k = 0; k < BUCKETS; k++) {
            if (count[k] > 0) {
                entries.add(new int[] {
                    (int) (red[k] / count[k]), (int) (green[k] / count[k]), (int) (blue[k] / count[k]), count[k]
                });
            }
        }
        colours = cut(entries);
        byte[][] parts = new byte[3][colours.length];
        for (int i = 0; i < colours.length; i++) {
            for (int c = 0; c < 3; c++) {
                parts[c][i] = (byte) (colours[i] >> 16 - 8 * c);
            }
        }
        model = new IndexColorModel(8, colours.length, parts[0], parts[1], parts[2]);
    }

    private static int bucket(int rgb) {
        return (rgb >> 9 & 0x7c00) | (rgb >> 6 & 0x3e0) | (rgb >> 3 & 0x1f);
    }

    private static int[] cut(List<int[]> entries) {
        List<List<int[]>> boxes = new ArrayList<>();
        boxes.add(entries);
        while (boxes.size() < SIZE) {
            int best = -1;
            double most = 0;
            for (int i = 0; i < boxes.size(); i++) {
                double weight = boxes.get(i).size() < 2 ? 0 : weight(boxes.get(i));
                if (weight > most) {
                    most = weight;
                    best = i;
                }
            }
            if (best < 0) {
                break;
            }
            List<int[]> box = new ArrayList<>(boxes.get(best));
            int channel = widest(box);
            box.sort(Comparator.comparingInt(e -> e[channel]));
            int half = middle(box);
            boxes.set(best, box.subList(0, half));
            boxes.add(box.subList(half, box.size()));
        }
        return boxes.stream().mapToInt(Palette::mean).toArray();
    }

    private static double weight(List<int[]> box) {
        return Math.sqrt(box.stream().mapToLong(e -> e[3]).sum()) * side(box, widest(box));
    }

    private static int side(List<int[]> box, int channel) {
        int least = box.stream().mapToInt(e -> e[channel]).min().orElse(0);
        return box.stream().mapToInt(e -> e[channel]).max().orElse(0) - least;
    }

    private static int widest(List<int[]> box) {
        int widest = 0;
        for (int c = 1; c < 3; c++) {
            widest = side(box, c) > side(box, widest) ? c : widest;
        }
        return widest;
    }

    private static int middle(List<int[]> box) {
        long all = box.stream().mapToLong(e -> e[3]).sum();
        long sum = 0;
        for (int i = 0; i < box.size() - 1; i++) {
            sum += box.get(i)[3];
            if (2 * sum >= all) {
                return i + 1;
            }
        }
        return box.size() - 1;
    }

    private static int mean(List<int[]> box) {
        long[] sums = new long[4];
        for (int[] entry : box) {
            for (int c = 0; c < 3; c++) {
                sums[c] += (long) entry[c] * entry[3];
            }
            sums[3] += entry[3];
        }
        long all = Math.max(1, sums[3]);
        return (int) (sums[0] / all) << 16 | (int) (sums[1] / all) << 8 | (int) (sums[2] / all);
    }

    /** Returns the image in the colours of this palette, each pixel in the nearest one of its bucket. */
    public BufferedImage indexed(BufferedImage image) {
        int width = image.getWidth();
        BufferedImage result = new BufferedImage(width, image.getHeight(), BufferedImage.TYPE_BYTE_INDEXED, model);
        int[] row = new int[width];
        byte[] indices = new byte[width];
        for (int y = 0; y < image.getHeight(); y++) {
            image.getRGB(0, y, width, 1, row, 0, width);
            for (int x = 0; x < width; x++) {
                indices[x] = index(row[x]);
            }
            result.getRaster().setDataElements(0, y, width, 1, indices);
        }
        return result;
    }

    private byte index(int rgb) {
        int k = bucket(rgb);
        if (!known[k]) {
            int[] distance = Arrays.stream(colours).map(c -> apart(c, rgb)).toArray();
            int best = 0;
            for (int i = 1; i < distance.length; i++) {
                best = distance[i] < distance[best] ? i : best;
            }
            nearest[k] = (byte) best;
            known[k] = true;
        }
        return nearest[k];
    }

    private static int apart(int a, int b) {
        int red = (a >> 16 & 255) - (b >> 16 & 255);
        int green = (a >> 8 & 255) - (b >> 8 & 255);
        int blue = (a & 255) - (b & 255);
        return red * red + green * green + blue * blue;
    }
}
