package troupe.paint.picture;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.stream.IntStream;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.field.ColourMap;
import troupe.run.view.Strip;

/**
 * Paints values over time as strips of greys, time to the right, with a scale in seconds and one of greys, which
 * ends at the first of 5, 10, 25, 50 and 100 percent that no value is above. Immutable; serves any thread.
 */
public final class StripPainter {
    private static final int ROW = 22;
    private static final int NAMES = 84;
    private static final int MARGIN = 14;
    private static final int SCALE = 22;
    private static final int GREYS = 36;
    private static final int[] TOPS = {5, 10, 25, 50, 100};

    private final Strip strip;
    private final Theme theme;

    /** Makes a painter. */
    public StripPainter(Strip strip, Theme theme) {
        this.strip = strip;
        this.theme = theme;
    }

    /** Returns the height of the strips and their scale in pixels. */
    public int height() {
        return Math.max(1, strip.rows().size()) * ROW + SCALE;
    }

    /** Returns the strips as an opaque image of the given width in pixels, from {@value Picture#MIN_WIDTH} on. */
    public BufferedImage image(int width) {
        int wide = Math.max(Picture.MIN_WIDTH, width);
        BufferedImage image = new BufferedImage(wide, height() + 2 * MARGIN, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(theme.color(Tone.CANVAS));
        g.fillRect(0, 0, wide, image.getHeight());
        g.translate(MARGIN, MARGIN);
        paint(g, wide - 2 * MARGIN);
        g.dispose();
        return image;
    }

    /** Paints the strips into the given width in pixels, without a ground. */
    public void paint(Graphics2D graphics, int width) {
        Graphics2D g = Shapes.smooth(graphics);
        g.setFont(Theme.font(12));
        int top = top();
        ColourMap greys = ColourMap.greys(theme);
        for (int r = 0; r < strip.rows().size(); r++) {
            paintRow(g, r, width, 100.0 / top, greys);
        }
        g.setColor(theme.color(Tone.DIM));
        int most = length();
        double bottom = (double) strip.rows().size() * ROW;
        for (int s = 0; s <= (most - 1) * strip.step() + 1e-9; s++) {
            double x = NAMES + (width - NAMES) * s / strip.step() / most;
            g.draw(new Rectangle2D.Double(x, bottom, 0, 4));
            String text = String.format(Locale.ROOT, "%d s", s);
            if (x + 3 + g.getFontMetrics().stringWidth(text) <= width) {
                g.drawString(text, (float) x + 3, (float) bottom + 15);
            }
        }
        for (int x = 0; x < GREYS; x++) {
            g.setColor(new Color(greys.argb((x + 0.5) / GREYS)));
            g.fill(new Rectangle2D.Double(x, bottom + 6, 1.5, 9));
        }
        g.setColor(theme.color(Tone.DIM));
        g.drawString(top + " %", GREYS + 6, (float) bottom + 15);
        g.dispose();
    }

    private void paintRow(Graphics2D g, int r, int width, double times, ColourMap greys) {
        double top = (double) r * ROW;
        double wide = (double) width - NAMES;
        int most = length();
        g.setColor(theme.color(Tone.TEXT));
        g.drawString(fitting(strip.names().get(r), g.getFontMetrics()), 0, (float) (top + ROW * 0.68));
        double[] row = strip.rows().get(r);
        for (int k = 0; k < row.length; k++) {
            g.setColor(Double.isNaN(row[k]) ? theme.color(Tone.PANEL) : new Color(greys.argb(row[k] * times)));
            g.fill(new Rectangle2D.Double(NAMES + wide * k / most, top + 3, wide / most + 0.5, ROW - 6));
        }
        g.setColor(theme.color(Tone.LINE));
        g.draw(new Rectangle2D.Double(NAMES, top + 3, wide - 1, ROW - 6));
    }

    /** Returns the percentage at which the greys end. */
    private int top() {
        double most = IntStream.range(0, strip.rows().size())
                .mapToDouble(strip::most)
                .max()
                .orElse(0);
        for (int percent : TOPS) {
            if (most <= percent / 100.0) {
                return percent;
            }
        }
        return 100;
    }

    private int length() {
        return strip.rows().stream().mapToInt(row -> row.length).max().orElse(1);
    }

    private static String fitting(String name, FontMetrics metrics) {
        String text = name;
        while (text.length() > 1 && metrics.stringWidth(text) > NAMES - 6) {
            text = text.substring(0, text.length() - 2) + "\u2026";
        }
        return text;
    }
}
