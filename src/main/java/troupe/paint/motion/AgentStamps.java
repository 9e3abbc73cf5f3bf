package troupe.paint.motion;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Keeps what an agent covers of the pixels around it, so that it is worked out once for many agents: the disc, and the
 * sign on it, for places to a quarter of a pixel and headings to a sixty-fourth of a turn. Used by one thread.
 */
final class AgentStamps {
    /** The largest radius in pixels that stamps are made of. */
    static final double MOST_RADIUS = 24;

    private static final int FINE = 4;
    /** Added to a place, it makes the part in which it then lies the nearest one. */
    static final double HALF_PART = 0.5 / FINE;

    private static final int HEADINGS = 64;
    /** More bytes of stamps than this are not kept. */
    private static final int MOST_BYTES = 1 << 23;

    private final Map<Key, byte[]> signs = new HashMap<>();
    private final Map<Sheet, byte[]> sheets = new HashMap<>();
    private final byte[][] discs = new byte[FINE * FINE][];
    private double radius = Double.NaN;
    private int reach;
    private int bytes;

    /** A sign drawn four times as large. */
    private record Sheet(GroupMark mark, int heading) {}

    /** A sign at a place within its pixel. */
    private record Key(GroupMark mark, int heading, int part) {}

    /** Prepares for agents of a radius in pixels, at most {@link #MOST_RADIUS}. What was made for another is dropped. */
    void prepare(double pixels) {
        if (pixels != radius) {
            radius = pixels;
            reach = (int) Math.ceil(pixels) + 1;
            forget();
        }
    }

    private void forget() {
        signs.clear();
        sheets.clear();
        Arrays.fill(discs, null);
        bytes = 0;
    }

    /** Returns the pixels on each side of the one that holds the middle. */
    int reach() {
        return reach;
    }

    /** Returns how many pixels a stamp is wide and high. */
    int side() {
        return 2 * reach + 1;
    }

    /** Returns the number of the part of its pixel in which a place lies; both in [0, 1). */
    static int part(double x, double y) {
        return (int) (y * FINE) * FINE + (int) (x * FINE);
    }

    /** Returns how much of each pixel the disc covers, row by row, from 0 to 255; not to be changed. */
    byte[] disc(int part) {
        if (discs[part] == null) {
            double r = FINE * radius;
            byte[] sheet = sheet(g -> g.fill(new Ellipse2D.Double(-r, -r, 2 * r, 2 * r)));
            for (int k = 0; k < discs.length; k++) {
                discs[k] = shrunk(sheet, k);
            }
        }
        return discs[part];
    }

    /** Returns how much of each pixel a sign covers that heads so, counter-clockwise from the right; not to be changed. */
    byte[] sign(GroupMark mark, double headingRad, int part) {
        int heading = Math.floorMod((int) Math.rint(headingRad / (2 * Math.PI) * HEADINGS), HEADINGS);
        Key key = new Key(mark, heading, part);
        byte[] made = signs.get(key);
        if (made == null) {
            if (bytes > MOST_BYTES) {
                forget();
            }
            byte[] sheet = sheets.computeIfAbsent(
                    new Sheet(mark, heading),
                    s -> sheet(g -> mark.fill(g, 0, 0, FINE * radius, 2 * Math.PI * heading / HEADINGS)));
            made = shrunk(sheet, part);
            signs.put(key, made);
            bytes += made.length;
        }
        return made;
    }

    /** Paints something four times as large, about the middle of a sheet. */
    private byte[] sheet(Consumer<Graphics2D> painting) {
        int side = FINE * (side() + 1);
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_BYTE_GRAY);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.translate(FINE * (reach + 1), FINE * (reach + 1));
        g.setColor(Color.WHITE);
        painting.accept(g);
        g.dispose();
        byte[] pixels = ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
        bytes += pixels.length;
        return pixels;
    }

    /** Shrinks a sheet so that its middle lies in the middle of a part of the middle pixel. */
    private byte[] shrunk(byte[] sheet, int part) {
        int wide = FINE * (side() + 1);
        int fromX = FINE - part % FINE;
        int fromY = FINE - part / FINE;
        byte[] small = new byte[side() * side()];
        for (int y = 0; y < side(); y++) {
            for (int x = 0; x < side(); x++) {
                int sum = 0;
                for (int k = 0; k < FINE; k++) {
                    int row = (FINE * y + fromY + k) * wide + FINE * x + fromX;
                    for (int m = 0; m < FINE; m++) {
                        sum += sheet[row + m] & 0xff;
                    }
                }
                small[y * side() + x] = (byte) ((sum + FINE * FINE / 2) / (FINE * FINE));
            }
        }
        return small;
    }
}
