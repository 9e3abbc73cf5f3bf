package troupe.paint;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Remembers which parts of a picture hold text or marks, so that no text covers another. One instance
 * serves one picture, from the first painter to the last; all in pixels.
 */
public final class Labels {
    private static final double GAP = 2;

    private final List<Rectangle2D> taken = new ArrayList<>();

    /** Makes an empty memory. */
    public Labels() {}

    /** Tells whether a rectangle is free of everything taken so far. Cost O(taken). */
    public boolean free(Rectangle2D rectangle) {
        return taken.stream().noneMatch(r -> r.intersects(rectangle));
    }

    /** Takes a rectangle. */
    public void take(Rectangle2D rectangle) {
        taken.add(new Rectangle2D.Double(
                rectangle.getX() - GAP,
                rectangle.getY() - GAP,
                rectangle.getWidth() + 2 * GAP,
                rectangle.getHeight() + 2 * GAP));
    }

    /** Returns the rectangle of a text centred at a pixel. */
    public static Rectangle2D around(Graphics2D g, Font font, String text, double x, double y) {
        FontMetrics metrics = g.getFontMetrics(font);
        double width = metrics.getStringBounds(text, g).getWidth();
        double height = metrics.getAscent() + metrics.getDescent();
        return new Rectangle2D.Double(x - width / 2, y - height / 2, width, height);
    }

    /** Draws a text into the rectangle that {@link #around} gave, and takes it. */
    public void draw(Graphics2D g, Font font, String text, Rectangle2D place, Color colour) {
        g.setFont(font);
        g.setColor(colour);
        float base = (float) (place.getY() + g.getFontMetrics(font).getAscent());
        g.drawString(text, (float) place.getX(), base);
        take(place);
    }
}
