package troupe.app.look;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.border.Border;
import troupe.paint.Theme;
import troupe.paint.Tone;

/**
 * Holds what a component needs to look like the studio. Immutable.
 *
 * @param scale how large everything is, 1 to 3; 1 stands for 100 %
 */
public record Look(Theme theme, Texts texts, double scale) {
    /** The size of body text in pixels at 100 %. */
    public static final float TEXT_SIZE = 12;

    /** Checks the scale. */
    public Look {
        if (!(scale >= 1 && scale <= 3)) {
            throw new IllegalArgumentException("scale " + scale + "; needs 1 to 3");
        }
    }

    /** Makes looks at 100 %. */
    public Look(Theme theme, Texts texts) {
        this(theme, texts, 1);
    }

    /** Returns these looks in another theme. */
    public Look with(Theme other) {
        return new Look(other, texts, scale);
    }

    /** Returns these looks in another language. */
    public Look with(Texts other) {
        return new Look(theme, other, scale);
    }

    /** Returns these looks at another scale, 1 to 3. */
    public Look scaled(double other) {
        return new Look(theme, texts, other);
    }

    /** Returns how many pixels stand for so many at 100 %. */
    public int px(double pixels) {
        return (int) Math.round(pixels * scale);
    }

    /** Returns an icon for 100 % as it is at this scale. */
    public Icon enlarged(Icon icon) {
        return scale == 1
                ? icon
                : new Icon() {
                    @Override
                    public void paintIcon(Component component, Graphics graphics, int x, int y) {
                        Graphics2D g = (Graphics2D) graphics.create();
                        g.translate(x, y);
                        g.scale(scale, scale);
                        icon.paintIcon(component, g, 0, 0);
                        g.dispose();
                    }

                    @Override
                    public int getIconWidth() {
                        return px(icon.getIconWidth());
                    }

                    @Override
                    public int getIconHeight() {
                        return px(icon.getIconHeight());
                    }
                };
    }

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
        return font(TEXT_SIZE);
    }

    /** Returns the font of headings. */
    public Font bold() {
        return bold(TEXT_SIZE);
    }

    /** Returns the plain font of a size in pixels at 100 %. */
    public Font font(float size) {
        return Theme.font((float) (size * scale));
    }

    /** Returns the bold font of a size in pixels at 100 %. */
    public Font bold(float size) {
        return Theme.bold((float) (size * scale));
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
