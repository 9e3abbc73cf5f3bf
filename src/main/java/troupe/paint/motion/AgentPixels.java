package troupe.paint.motion;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/**
 * Lays many agents and their trails into one picture, pixel by pixel, and draws that: for windows in which thousands
 * move, where a shape for each takes too long. Shows what the shapes would show, but for places rounded to a quarter of a
 * pixel and headings to a sixty-fourth of a turn. Holds room for the picture from one time to the next. Used by one
 * thread.
 */
public final class AgentPixels {
    private final AgentStamps stamps = new AgentStamps();
    private BufferedImage image;
    private int[] pixels = new int[0];
    private float[] cover = new float[1024];
    /** The columns of each row of a line's box that it may cover. */
    private int[] rowBegin = new int[64];

    private int[] rowEnd = new int[64];
    private int wide;
    private Rectangle at = new Rectangle();
    /** The part of the picture that is not empty, from the first column and row to before the last. */
    private int fromX;

    private int fromY;
    private int toX;
    private int toY;
    private double scale;
    private double shiftX;
    private double shiftY;

    /** Makes an empty picture. */
    public AgentPixels() {
        // room is taken when the size is known
    }

    /**
     * Begins a picture of what graphics show; tells whether that can be done: they must have a clip, and neither turn
     * nor stretch.
     */
    boolean begin(Graphics2D g) {
        AffineTransform transform = g.getTransform();
        boolean plain = transform.getShearX() == 0
                && transform.getShearY() == 0
                && transform.getScaleX() == transform.getScaleY()
                && transform.getScaleX() > 0;
        if (!plain || g.getClip() == null) {
            return false;
        }
        at = transform.createTransformedShape(g.getClipBounds()).getBounds();
        scale = transform.getScaleX();
        shiftX = transform.getTranslateX() - at.x;
        shiftY = transform.getTranslateY() - at.y;
        if (image == null || image.getWidth() < at.width || image.getHeight() < at.height) {
            image = new BufferedImage(Math.max(1, at.width), Math.max(1, at.height), BufferedImage.TYPE_INT_ARGB_PRE);
            pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
            wide = image.getWidth();
            toY = 0;
        }
        clear();
        return true;
    }

    private void clear() {
        for (int y = fromY; y < toY; y++) {
            Arrays.fill(pixels, y * wide + fromX, y * wide + toX, 0);
        }
        fromX = Integer.MAX_VALUE;
        fromY = Integer.MAX_VALUE;
        toX = 0;
        toY = 0;
    }

    /** Notes that something was laid into columns and rows, each from the first to before the last. */
    private void touch(int left, int right, int top, int bottom) {
        fromX = Math.min(fromX, left);
        toX = Math.max(toX, right);
        fromY = Math.min(fromY, top);
        toY = Math.max(toY, bottom);
    }

    /** Draws the picture where it belongs. */
    void draw(Graphics2D g) {
        if (fromX < toX && fromY < toY) {
            Graphics2D device = (Graphics2D) g.create();
            device.setTransform(AffineTransform.getTranslateInstance(at.x, at.y));
            device.drawImage(image, fromX, fromY, toX, toY, fromX, fromY, toX, toY, null);
            device.dispose();
        }
    }

    /** Tells whether agents of a radius are small enough to be laid in. */
    boolean takes(double radius) {
        return radius * scale <= AgentStamps.MOST_RADIUS;
    }

    /** Says how large the next agents are, in the pixels of the graphics. */
    void size(double radius) {
        stamps.prepare(radius * scale);
    }

    /** Lays in a disc of the last {@link #size} about a place in the pixels of the graphics. */
    void disc(double x, double y, Color colour) {
        double px = x * scale + shiftX + AgentStamps.HALF_PART;
        double py = y * scale + shiftY + AgentStamps.HALF_PART;
        if (isNear(px, py)) {
            int column = (int) Math.floor(px);
            int row = (int) Math.floor(py);
            lay(stamps.disc(AgentStamps.part(px - column, py - row)), column, row, colour);
        }
    }

    /** Lays in a group's sign on such a disc. */
    void sign(GroupMark mark, double x, double y, double headingRad, Color colour) {
        double px = x * scale + shiftX + AgentStamps.HALF_PART;
        double py = y * scale + shiftY + AgentStamps.HALF_PART;
        if (isNear(px, py)) {
            int column = (int) Math.floor(px);
            int row = (int) Math.floor(py);
            lay(stamps.sign(mark, headingRad, AgentStamps.part(px - column, py - row)), column, row, colour);
        }
    }

    private boolean isNear(double px, double py) {
        int reach = stamps.reach();
        return px > -reach && py > -reach && px < at.width + reach && py < at.height + reach;
    }

    private void lay(byte[] stamp, int column, int row, Color colour) {
        int side = stamps.side();
        int left = column - stamps.reach();
        int top = row - stamps.reach();
        int first = Math.max(0, -left);
        int end = Math.min(side, at.width - left);
        int last = Math.min(side, at.height - top);
        int argb = colour.getRGB();
        touch(left + first, left + end, Math.max(0, top), top + last);
        for (int y = Math.max(0, -top); y < last; y++) {
            int to = (top + y) * wide + left;
            int from = y * side;
            for (int x = first; x < end; x++) {
                int share = stamp[from + x] & 0xff;
                if (share != 0) {
                    pixels[to + x] = over(pixels[to + x], argb, share);
                }
            }
        }
    }

    /** Returns a premultiplied pixel under an opaque colour that covers {@code share} of 255 of it. */
    private static int over(int below, int colour, int share) {
        if (share == 255) {
            return colour | 0xff000000;
        }
        int rest = 255 - share;
        int alpha = share + part((below >>> 24) * rest);
        int red = part((colour >> 16 & 0xff) * share + (below >> 16 & 0xff) * rest);
        int green = part((colour >> 8 & 0xff) * share + (below >> 8 & 0xff) * rest);
        int blue = part((colour & 0xff) * share + (below & 0xff) * rest);
        return alpha << 24 | red << 16 | green << 8 | blue;
    }

    /** Divides by 255, rounding. */
    private static int part(int product) {
        int rounded = product + 128;
        return rounded + (rounded >> 8) >> 8;
    }

    /**
     * Lays in a line with round ends.
     *
     * @param xy {@code x0, y0, x1, y1, …} in the pixels of the graphics
     * @param count how many of the numbers count, at least 2
     * @param width in the pixels of the graphics
     */
    void line(double[] xy, int count, double width, Color colour) {
        float half = (float) (width * scale / 2 + 0.5);
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < count; k += 2) {
            minX = Math.min(minX, xy[k]);
            maxX = Math.max(maxX, xy[k]);
            minY = Math.min(minY, xy[k + 1]);
            maxY = Math.max(maxY, xy[k + 1]);
        }
        int left = (int) Math.max(0, Math.floor(minX * scale + shiftX - half));
        int top = (int) Math.max(0, Math.floor(minY * scale + shiftY - half));
        int right = (int) Math.min(at.width, Math.ceil(maxX * scale + shiftX + half));
        int bottom = (int) Math.min(at.height, Math.ceil(maxY * scale + shiftY + half));
        if (left >= right || top >= bottom) {
            return;
        }
        touch(left, right, top, bottom);
        Rectangle box = new Rectangle(left, top, right - left, bottom - top);
        if (cover.length < box.width * box.height) {
            cover = new float[2 * box.width * box.height];
        }
        if (rowEnd.length < box.height) {
            rowBegin = new int[2 * box.height];
            rowEnd = new int[2 * box.height];
        }
        Arrays.fill(rowBegin, 0, box.height, Integer.MAX_VALUE);
        Arrays.fill(rowEnd, 0, box.height, 0);
        int from = 0;
        for (int k = 2; k < count; k += 2) {
            // a place on the straight way between its neighbours adds nothing
            if (k + 2 >= count || !isStraight(xy, from, k, k + 2)) {
                cover(box, half, xy, from, k);
                from = k;
            }
        }
        layCover(box, colour);
    }

    /** Tells whether the middle one of three places lies between the others, to a tenth of a pixel. */
    private boolean isStraight(double[] xy, int a, int b, int c) {
        double dx = xy[c] - xy[a];
        double dy = xy[c + 1] - xy[a + 1];
        double along = (xy[b] - xy[a]) * dx + (xy[b + 1] - xy[a + 1]) * dy;
        double across = (xy[b] - xy[a]) * dy - (xy[b + 1] - xy[a + 1]) * dx;
        double squared = dx * dx + dy * dy;
        return along >= 0 && along <= squared && across * across * scale * scale <= 0.01 * squared;
    }

    /** Notes how much of each pixel of a box one piece of a line covers: what it does not reach keeps its value. */
    private void cover(Rectangle box, float half, double[] xy, int a, int b) {
        float x0 = (float) (xy[a] * scale + shiftX - 0.5);
        float y0 = (float) (xy[a + 1] * scale + shiftY - 0.5);
        float dx = (float) ((xy[b] - xy[a]) * scale);
        float dy = (float) ((xy[b + 1] - xy[a + 1]) * scale);
        float squared = dx * dx + dy * dy;
        float inverse = squared > 1e-6f ? 1 / squared : 0;
        int left = Math.max(box.x, (int) Math.ceil(Math.min(x0, x0 + dx) - half));
        int right = Math.min(box.x + box.width, (int) Math.floor(Math.max(x0, x0 + dx) + half) + 1);
        int top = Math.max(box.y, (int) Math.ceil(Math.min(y0, y0 + dy) - half));
        int bottom = Math.min(box.y + box.height, (int) Math.floor(Math.max(y0, y0 + dy) + half) + 1);
        // half as wide as what a row cuts out of the strip around the line
        float wideHalf = dy == 0 ? Float.MAX_VALUE : half * (float) Math.sqrt(squared) / Math.abs(dy);
        float slope = dy == 0 ? 0 : dx / dy;
        for (int y = top; y < bottom; y++) {
            float middle = x0 + (y - y0) * slope;
            int first = Math.max(left, (int) Math.ceil(middle - wideHalf));
            int end = Math.min(right, (int) Math.min(right, Math.floor(middle + wideHalf) + 1));
            int row = (y - box.y) * box.width - box.x;
            rowBegin[y - box.y] = Math.min(rowBegin[y - box.y], first - box.x);
            rowEnd[y - box.y] = Math.max(rowEnd[y - box.y], end - box.x);
            for (int x = first; x < end; x++) {
                float share = ((x - x0) * dx + (y - y0) * dy) * inverse;
                share = share < 0 ? 0 : share > 1 ? 1 : share;
                float awayX = x - x0 - share * dx;
                float awayY = y - y0 - share * dy;
                float away = awayX * awayX + awayY * awayY;
                if (away < half * half) {
                    float covered = half - (float) Math.sqrt(away);
                    covered = covered > 1 ? 1 : covered;
                    if (covered > cover[row + x]) {
                        cover[row + x] = covered;
                    }
                }
            }
        }
    }

    private void layCover(Rectangle box, Color colour) {
        int argb = colour.getRGB();
        int alpha = colour.getAlpha();
        for (int y = 0; y < box.height; y++) {
            int to = (box.y + y) * wide + box.x;
            int from = y * box.width;
            for (int x = rowBegin[y]; x < rowEnd[y]; x++) {
                float covered = cover[from + x];
                if (covered > 0) {
                    cover[from + x] = 0;
                    pixels[to + x] = over(pixels[to + x], argb, (int) (covered * alpha + 0.5f));
                }
            }
        }
    }
}
