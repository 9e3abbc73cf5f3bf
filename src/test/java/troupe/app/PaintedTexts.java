package troupe.app;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.text.AttributedCharacterIterator;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import troupe.paint.PassingGraphics;

/**
 * Paints like the graphics that it is made of, and keeps every text that is painted with where it stands and how much
 * of it can be seen.
 */
public final class PaintedTexts extends PassingGraphics {
    private final List<Text> texts;

    /** A text, the box it takes in pixels of the device, and the box that it is cut to; null if it is not cut. */
    public record Text(String words, Rectangle2D box, Rectangle2D clip) {

        /** Tells whether anything of the text can be seen. */
        boolean isSeen() {
            return clip == null || clip.intersects(box);
        }

        /** Returns how many pixels are cut off at the left or the right. */
        double cut() {
            return clip == null ? 0 : Math.max(clip.getMinX() - box.getMinX(), box.getMaxX() - clip.getMaxX());
        }
    }

    private PaintedTexts(Graphics2D to, List<Text> texts) {
        super(to);
        this.texts = texts;
    }

    /** Paints a component that is on the screen and returns its texts. Belongs to the event thread. */
    static List<Text> of(Component component) {
        return of(component.getWidth(), component.getHeight(), component::printAll);
    }

    /** Has something painted on a picture and returns its texts. */
    public static List<Text> of(int width, int height, Consumer<Graphics2D> painting) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setClip(0, 0, width, height);
        List<Text> texts = new ArrayList<>();
        painting.accept(new PaintedTexts(g, texts));
        g.dispose();
        return texts;
    }

    private void keep(String words, double x, double y) {
        if (words.isBlank()) {
            return;
        }
        // the space at which a line was wrapped may hang over the edge
        Rectangle2D box = to.getFont().getStringBounds(words.stripTrailing(), to.getFontRenderContext());
        Rectangle2D there = new Rectangle2D.Double(x + box.getX(), y + box.getY(), box.getWidth(), box.getHeight());
        Shape clip = to.getClip();
        AffineTransform place = to.getTransform();
        texts.add(new Text(
                words,
                place.createTransformedShape(there).getBounds2D(),
                clip == null ? null : place.createTransformedShape(clip).getBounds2D()));
    }

    @Override
    public void drawString(String words, float x, float y) {
        keep(words, x, y);
        to.drawString(words, x, y);
    }

    @Override
    public void drawString(AttributedCharacterIterator words, float x, float y) {
        StringBuilder plain = new StringBuilder();
        for (char c = words.first(); c != AttributedCharacterIterator.DONE; c = words.next()) {
            plain.append(c);
        }
        keep(plain.toString(), x, y);
        to.drawString(words, x, y);
    }

    @Override
    public Graphics create() {
        return new PaintedTexts((Graphics2D) to.create(), texts);
    }
}
