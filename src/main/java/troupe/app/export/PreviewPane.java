package troupe.app.export;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.LineBreakMeasurer;
import java.awt.font.TextAttribute;
import java.awt.font.TextLayout;
import java.text.AttributedString;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** Shows a preview: a picture as large as fits, or lines of text. */
final class PreviewPane extends Drawn {
    private static final int PADDING = 12;
    private final transient Look look;
    private transient Preview shown;

    PreviewPane(Look look) {
        this.look = look;
        setName("export.preview");
        setPreferredSize(new Dimension(420, 320));
        getAccessibleContext().setAccessibleName(look.text("export.preview"));
    }

    /** Goes on showing the preview before, faintly named as such, until the next one is there. */
    void waiting() {
        repaint();
    }

    /** Shows a preview. */
    void show(Preview preview) {
        String text = preview.wrong() ? look.texts().tell(preview.text()) : preview.text();
        shown = new Preview(preview.image(), text, preview.wrong());
        getAccessibleContext().setAccessibleDescription(text);
        repaint();
    }

    /** Returns what is shown, null before the first. */
    Preview shown() {
        return shown;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        g.setColor(look.color(Tone.CANVAS));
        g.fillRoundRect(0, 0, getWidth(), getHeight(), 14, 14);
        if (shown == null) {
            g.setFont(look.font());
            g.setColor(look.color(Tone.DIM));
            g.drawString(look.text("export.preview"), PADDING, 24);
        } else if (shown.image().isPresent()) {
            paintImage(g);
        } else if (shown.wrong()) {
            paintWrong(g);
        } else {
            paintText(g);
        }
        g.dispose();
    }

    private void paintImage(Graphics2D g) {
        var image = shown.image().get();
        double scale = Math.min(
                (getWidth() - 2.0 * PADDING) / image.getWidth(), (getHeight() - 2.0 * PADDING) / image.getHeight());
        int wide = (int) Math.max(1, scale * image.getWidth());
        int high = (int) Math.max(1, scale * image.getHeight());
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.drawImage(image, (getWidth() - wide) / 2, (getHeight() - high) / 2, wide, high, null);
    }

    /** Paints why there is nothing to be seen, as many lines as it takes. */
    private void paintWrong(Graphics2D g) {
        AttributedString words = new AttributedString(shown.text());
        words.addAttribute(TextAttribute.FONT, look.font());
        LineBreakMeasurer lines = new LineBreakMeasurer(words.getIterator(), g.getFontRenderContext());
        g.setColor(look.color(Tone.MOVE));
        float y = PADDING;
        while (lines.getPosition() < shown.text().length()) {
            TextLayout line = lines.nextLayout(Math.max(40, getWidth() - 2 * PADDING));
            line.draw(g, PADDING, y + line.getAscent());
            y += line.getAscent() + line.getDescent() + line.getLeading();
        }
    }

    private void paintText(Graphics2D g) {
        g.setFont(new java.awt.Font(java.awt.Font.MONOSPACED, java.awt.Font.PLAIN, (int) Look.TEXT_SIZE - 1));
        g.setColor(look.color(Tone.TEXT));
        FontMetrics metrics = g.getFontMetrics();
        g.clipRect(PADDING, PADDING, getWidth() - 2 * PADDING, getHeight() - 2 * PADDING);
        int y = PADDING + metrics.getAscent();
        for (String line : shown.text().split("\n")) {
            g.drawString(line.replace("\r", "").replace("\t", "    "), PADDING, y);
            y += metrics.getHeight();
            if (y > getHeight()) {
                break;
            }
        }
    }
}
