package troupe.app.look;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.border.Border;
import troupe.paint.Theme;
import troupe.paint.Tone;

/** Holds what a component needs to look like the studio: theme and texts. Immutable. */
public record Look(Theme theme, Texts texts) {
    /** The size of body text in pixels at 100 %. */
    public static final float TEXT_SIZE = 12;

    /** Returns the colour for a purpose. */
    public Color color(Tone tone) {
        return theme.color(tone);
    }

    /** Returns a mixture of two colours, {@code share} of the first in [0, 1]. */
    public Color mix(Tone first, Tone second, double share) {
        return mix(color(first), color(second), share);
    }

    /** Returns a mixture of two colours, {@code share} of the first in [0, 1]. */
    public static Color mix(Color a, Color b, double share) {
        return new Color(
                mix(a.getRed(), b.getRed(), share),
                mix(a.getGreen(), b.getGreen(), share),
                mix(a.getBlue(), b.getBlue(), share));
    }

    private static int mix(int a, int b, double share) {
        return (int) Math.round(a * share + b * (1 - share));
    }

    /** Returns the background of what is selected. */
    public Color selected() {
        return mix(Tone.ACCENT, Tone.PANEL, 0.14);
    }

    /** Returns the background of what the pointer is over. */
    public Color hovered() {
        return mix(Tone.TEXT, Tone.PANEL, 0.06);
    }

    /** Returns the font of body text. */
    public Font font() {
        return Theme.font(TEXT_SIZE);
    }

    /** Returns the font of headings. */
    public Font bold() {
        return Theme.bold(TEXT_SIZE);
    }

    /** Returns the text of a key. */
    public String text(String key) {
        return texts.get(key);
    }

    /** Makes a label of body text. */
    public JLabel label(String text, Tone tone) {
        JLabel label = new JLabel(text);
        label.setFont(font());
        label.setForeground(color(tone));
        return label;
    }

    /** Returns a border of one thin line on some sides, 0 or 1 each. */
    public Border line(int top, int left, int bottom, int right) {
        return BorderFactory.createMatteBorder(top, left, bottom, right, color(Tone.LINE));
    }

    /** Returns a copy of the graphics that smooths shapes and text; the caller disposes of it. */
    public static Graphics2D smooth(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        return g;
    }

    /** Gives a component a fixed size in pixels. */
    public static <C extends JComponent> C sized(C component, int width, int height) {
        Dimension size = new Dimension(width, height);
        component.setPreferredSize(size);
        component.setMinimumSize(size);
        component.setMaximumSize(size);
        return component;
    }
}
