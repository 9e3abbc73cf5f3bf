package troupe.paint;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import troupe.run.Strip;

/** Paints values over time as strips of greys, time to the right, with a scale in seconds. Immutable; serves any thread. */
public final class StripPainter {
    private static final int ROW = 26;
    private static final int NAMES = 90;
    private static final int MARGIN = 14;
    private static final int SCALE = 24;

    private final Strip strip;
    private final Theme theme;

    /** Makes a painter. */
    public StripPainter(Strip strip, Theme theme) {
        this.strip = strip;
        this.theme = theme;
    }

    /** Returns the strips as an opaque image of the given width in pixels, from {@value Picture#MIN_WIDTH} on. */
    public BufferedImage image(int width) {
        int height = 2 * MARGIN + Math.max(1, strip.rows().size()) * ROW + SCALE;
        BufferedImage image = new BufferedImage(Math.max(Picture.MIN_WIDTH, width), height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = Shapes.smooth(image.createGraphics());
        g.setColor(theme.color(Tone.CANVAS));
        g.fillRect(0, 0, image.getWidth(), height);
        paint(g, image.getWidth());
        g.dispose();
        return image;
    }

    private void paint(Graphics2D g, int width) {
        g.setFont(Theme.font(12));
        double left = MARGIN + NAMES;
        double wide = width - MARGIN - left;
        int most = strip.rows().stream().mapToInt(row -> row.length).max().orElse(1);
        ColourMap greys = ColourMap.greys(theme);
        for (int r = 0; r < strip.rows().size(); r++) {
            double top = MARGIN + (double) r * ROW;
            g.setColor(theme.color(Tone.TEXT));
            g.drawString(strip.names().get(r), MARGIN, (float) (top + ROW * 0.66));
            double[] row = strip.rows().get(r);
            for (int k = 0; k < row.length; k++) {
                g.setColor(Double.isNaN(row[k]) ? theme.color(Tone.PANEL) : new Color(greys.argb(row[k])));
                g.fill(new Rectangle2D.Double(left + wide * k / most, top + 3, wide / most + 0.5, ROW - 6));
            }
            g.setColor(theme.color(Tone.LINE));
            g.draw(new Rectangle2D.Double(left, top + 3, wide, ROW - 6));
        }
        g.setColor(theme.color(Tone.DIM));
        for (int s = 0; s <= (most - 1) * strip.step() + 1e-9; s++) {
            double x = left + wide * s / strip.step() / most;
            double bottom = MARGIN + (double) strip.rows().size() * ROW;
            g.draw(new Rectangle2D.Double(x, bottom, 0, 5));
            g.drawString(String.format(Locale.ROOT, "%d s", s), (float) x + 3, (float) bottom + 16);
        }
    }
}
