package troupe.paint.solid;

import java.awt.image.BufferedImage;
import java.util.Arrays;

/**
 * Keeps for each sample the colour and the depth of the nearest face drawn so far, so that faces may come in any
 * order, and may lie over, under and through each other. Of two that are equally near, the first stays. Serves
 * one thread.
 *
 * <p>Source: Catmull, "A subdivision algorithm for computer display of curved surfaces" (1974), the depth
 * buffer; each sample is its centre, a face holds it by the even-odd rule.
 */
final class DepthRaster {
    private final int width;
    private final int height;
    private final int[] colours;
    private final float[] depths;
    private final int[] marks;
    private double[] crossings = new double[16];
    private int generation;

    /** Makes a raster of {@code width x height} samples. */
    DepthRaster(int width, int height) {
        this.width = width;
        this.height = height;
        this.colours = new int[width * height];
        this.depths = new float[width * height];
        this.marks = new int[width * height];
    }

    /** Tells whether it has that many samples. */
    boolean isOf(int wide, int high) {
        return width == wide && height == high;
    }

    /** Drops everything that was drawn and fills the background with a colour, {@code 0xrrggbb}. */
    void clear(int rgb) {
        Arrays.fill(colours, rgb);
        Arrays.fill(depths, Float.NEGATIVE_INFINITY);
        generation++;
    }

    /** Drops what was drawn where the present figure has no marks. */
    void keepMarked(int rgb) {
        for (int i = 0; i < marks.length; i++) {
            if (marks[i] != generation) {
                colours[i] = rgb;
                depths[i] = Float.NEGATIVE_INFINITY;
            }
        }
    }

    /** Begins a figure: a sample where it is hidden is blended once, however many of its parts lie there. */
    void begin() {
        generation++;
    }

    /** Marks the samples of a ring for the present figure; what is {@linkplain Ink#masked masked} leaves them alone. */
    void mark(double[] xs, double[] ys) {
        scan(xs, ys, (row, from, to) -> Arrays.fill(marks, row * width + from, row * width + to, generation));
    }

    /**
     * How a face is coloured.
     *
     * @param rgb {@code 0xrrggbb}
     * @param hidden with what opacity it shows through what lies before it, 0 to 1
     * @param masked whether it leaves out the samples marked for the present figure
     * @param glass with what opacity it covers what lies behind it, without hiding it; 0 for a face that hides
     */
    record Ink(int rgb, double hidden, boolean masked, double glass) {
        boolean plain() {
            return hidden == 0 && !masked && glass == 0;
        }
    }

    /** Fills a ring of pixels that lies in a plane. Cost O(rows · corners + samples). */
    void fill(double[] xs, double[] ys, Camera.Plane plane, Ink ink) {
        scan(xs, ys, (row, from, to) -> fillRow(row, from, to, plane, ink));
    }

    /** Takes a stretch of samples of a row, {@code from} inclusive to {@code to} exclusive. */
    private interface Stretch {
        void take(int row, int from, int to);
    }

    private void scan(double[] xs, double[] ys, Stretch taker) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (double y : ys) {
            least = Math.min(least, y);
            most = Math.max(most, y);
        }
        int first = (int) Math.max(0, Math.ceil(least - 0.5));
        int last = (int) Math.min(height - 1.0, Math.ceil(most - 0.5) - 1);
        if (crossings.length < xs.length) {
            crossings = new double[2 * xs.length];
        }
        for (int row = first; row <= last; row++) {
            int count = cross(xs, ys, row + 0.5);
            for (int k = 0; k + 1 < count; k += 2) {
                int from = (int) Math.max(0, Math.ceil(crossings[k] - 0.5));
                int to = (int) Math.min(width, Math.ceil(crossings[k + 1] - 0.5));
                if (from < to) {
                    taker.take(row, from, to);
                }
            }
        }
    }

    private int cross(double[] xs, double[] ys, double y) {
        int count = 0;
        for (int i = 0, j = xs.length - 1; i < xs.length; j = i++) {
            if ((ys[i] <= y) != (ys[j] <= y)) {
                double x = xs[i] + (y - ys[i]) * (xs[j] - xs[i]) / (ys[j] - ys[i]);
                int at = count++;
                while (at > 0 && crossings[at - 1] > x) {
                    crossings[at] = crossings[at - 1];
                    at--;
                }
                crossings[at] = x;
            }
        }
        return count;
    }

    private void fillRow(int row, int from, int to, Camera.Plane plane, Ink ink) {
        double start = plane.at(from + 0.5, row + 0.5);
        int base = row * width;
        boolean plain = ink.plain();
        for (int col = from; col < to; col++) {
            float depth = (float) (start + (col - from) * plane.a());
            int i = base + col;
            if (plain) {
                if (depth > depths[i]) {
                    depths[i] = depth;
                    colours[i] = ink.rgb();
                }
            } else {
                lay(i, depth, ink);
            }
        }
    }

    private void lay(int i, float depth, Ink ink) {
        boolean marked = marks[i] == generation;
        if (ink.masked() && marked) {
            return;
        }
        if (ink.glass() > 0) {
            if (depth > depths[i] && !marked) {
                colours[i] = mix(ink.rgb(), colours[i], (int) (256 * ink.glass()));
                marks[i] = generation;
            }
            return;
        }
        if (depth > depths[i]) {
            depths[i] = depth;
            colours[i] = ink.rgb();
        } else if (ink.hidden() > 0 && !marked) {
            colours[i] = mix(ink.rgb(), colours[i], (int) (256 * ink.hidden()));
        }
        marks[i] = ink.hidden() > 0 ? generation : marks[i];
    }

    private static int mix(int top, int below, int share) {
        int redBlue = ((top & 0xff00ff) * share + (below & 0xff00ff) * (256 - share)) >>> 8 & 0xff00ff;
        int green = ((top & 0xff00) * share + (below & 0xff00) * (256 - share)) >>> 8 & 0xff00;
        return redBlue | green;
    }

    /** Returns the picture with {@code factor x factor} samples for each pixel, 1 or 2. */
    BufferedImage image(int factor) {
        int wide = width / factor;
        int high = height / factor;
        BufferedImage image = new BufferedImage(wide, high, BufferedImage.TYPE_INT_RGB);
        int[] row = new int[wide];
        for (int y = 0; y < high; y++) {
            if (factor == 1) {
                System.arraycopy(colours, y * width, row, 0, wide);
            } else {
                for (int x = 0, i = 2 * y * width; x < wide; x++, i += 2) {
                    row[x] = mean(colours[i], colours[i + 1], colours[i + width], colours[i + width + 1]);
                }
            }
            image.getRaster().setDataElements(0, y, wide, 1, row);
        }
        return image;
    }

    private static int mean(int a, int b, int c, int d) {
        int redBlue = ((a & 0xff00ff) + (b & 0xff00ff) + (c & 0xff00ff) + (d & 0xff00ff) + 0x20002) >>> 2 & 0xff00ff;
        int green = ((a & 0xff00) + (b & 0xff00) + (c & 0xff00) + (d & 0xff00) + 0x200) >>> 2 & 0xff00;
        return redBlue | green;
    }
}
