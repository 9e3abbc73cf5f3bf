package troupe.paint;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;

/** Paints a bar of a round length in metres. */
public final class ScaleBar {
    /** The height in pixels that a bar takes, text included. */
    public static final int HEIGHT = 26;

    private static final double LEAST_PIXELS = 60;
    private static final float TEXT_SIZE = 12;

    private ScaleBar() {}

    /** Returns the least of 1, 2, 5 times a power of ten that is at least {@code least}, which is above 0. */
    public static double nice(double least) {
        double power = 1;
        while (power > least) {
            power /= 10;
        }
        while (power * 10 <= least) {
            power *= 10;
        }
        double share = least / power;
        return share <= 1 ? power : share <= 2 ? 2 * power : share <= 5 ? 5 * power : 10 * power;
    }

    /** Returns the length in pixels of the bar at the scale of a view. */
    public static double width(Viewport view) {
        return nice(LEAST_PIXELS / view.scale()) * view.scale();
    }

    /** Paints the bar with its right end at pixel {@code right} and its foot at {@code bottom}. */
    public static void paint(Graphics2D graphics, Viewport view, Theme theme, double right, double bottom) {
        Graphics2D g = Shapes.smooth(graphics);
        double metres = nice(LEAST_PIXELS / view.scale());
        double left = right - width(view);
        Path2D bar = new Path2D.Double();
        bar.moveTo(left, bottom - 8);
        bar.lineTo(left, bottom);
        bar.moveTo(left, bottom - 4);
        bar.lineTo(right, bottom - 4);
        bar.moveTo(right, bottom - 8);
        bar.lineTo(right, bottom);
        g.setColor(theme.color(Tone.TEXT, 0.8));
        g.setStroke(Theme.line(1.4f));
        g.draw(bar);
        String text =
                (metres < 1 ? String.format(Locale.ROOT, "%.2f", metres) : String.format(Locale.ROOT, "%.0f", metres))
                        + " m";
        Font font = Theme.font(TEXT_SIZE);
        Rectangle2D place = Labels.around(g, font, text, (left + right) / 2, bottom - 17);
        new Labels().draw(g, font, text, place, theme.color(Tone.TEXT));
        g.dispose();
    }
}
