package troupe.paint;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.text.AttributedCharacterIterator;

/**
 * Paints a block for each letter of a text, as wide and high on every machine, so that pictures with texts can be
 * compared though fonts differ.
 */
public final class BlockTexts extends PassingGraphics {
    private static final double WIDE = 0.55;

    /** Makes graphics that paint with others. */
    public BlockTexts(Graphics2D to) {
        super(to);
    }

    @Override
    public Graphics create() {
        return new BlockTexts((Graphics2D) to.create());
    }

    @Override
    public FontMetrics getFontMetrics(Font font) {
        return new Blocks(font);
    }

    @Override
    public FontMetrics getFontMetrics() {
        return new Blocks(getFont());
    }

    @Override
    public void drawString(String words, float x, float y) {
        double size = getFont().getSize2D();
        for (int i = 0; i < words.length(); i++) {
            if (words.charAt(i) != ' ') {
                double high = size * (0.45 + words.charAt(i) % 4 * 0.1);
                to.fill(new Rectangle2D.Double(x + i * size * WIDE, y - high, size * WIDE - 1, high));
            }
        }
    }

    @Override
    public void drawString(AttributedCharacterIterator words, float x, float y) {
        throw new UnsupportedOperationException("a text with attributes");
    }

    /** Measures blocks. */
    private static final class Blocks extends FontMetrics {
        private static final long serialVersionUID = 1;

        Blocks(Font font) {
            super(font);
        }

        @Override
        public int stringWidth(String words) {
            return (int) Math.ceil(words.length() * font.getSize2D() * WIDE);
        }

        @Override
        public int charsWidth(char[] letters, int offset, int length) {
            return stringWidth(new String(letters, offset, length));
        }

        @Override
        public Rectangle2D getStringBounds(String words, Graphics context) {
            return new Rectangle2D.Double(
                    0, -getAscent(), words.length() * (double) font.getSize2D() * WIDE, getAscent() + getDescent());
        }

        @Override
        public int getAscent() {
            return (int) Math.ceil(0.9 * font.getSize2D());
        }

        @Override
        public int getDescent() {
            return (int) Math.ceil(0.25 * font.getSize2D());
        }

        @Override
        public int getHeight() {
            return getAscent() + getDescent();
        }
    }
}
