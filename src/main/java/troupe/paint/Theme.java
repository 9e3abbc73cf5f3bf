package troupe.paint;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.util.Locale;
import troupe.scene.Ability;

/** Gives colours, line styles and fonts for light or for dark surroundings. */
public enum Theme {
    LIGHT,
    DARK;

    /** The contrast of signs with what they stand on, WCAG 2.1, section 1.4.11. */
    static final double LEAST_CONTRAST = 3;

    /** The width in pixels of a path drawn at scale 1. */
    public static final float PATH_WIDTH = 4;

    /** Finds a theme by its word, {@code light} or {@code dark}. */
    public static Theme of(String word) {
        for (Theme theme : values()) {
            if (theme.key().equals(word)) {
                return theme;
            }
        }
        throw new IllegalArgumentException("theme '" + word + "'; known are light, dark");
    }

    /** Returns the word for it in settings. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Returns the colour for a purpose. */
    public Color color(Tone tone) {
        return this == LIGHT ? tone.light() : tone.dark();
    }

    /** Returns the colour for a purpose, {@code opacity} in [0, 1]. */
    public Color color(Tone tone, double opacity) {
        Color c = color(tone);
        return new Color(c.getRed(), c.getGreen(), c.getBlue(), (int) Math.round(255 * opacity));
    }

    /**
     * Returns how far two colours are apart in luminance, from 1 for none to 21 for black on white: the contrast ratio
     * of WCAG 2.1, section 1.4.3.
     */
    public static double contrast(Color a, Color b) {
        double light = Math.max(luminance(a), luminance(b));
        double dark = Math.min(luminance(a), luminance(b));
        return (light + 0.05) / (dark + 0.05);
    }

    private static double luminance(Color c) {
        return 0.2126 * linear(c.getRed()) + 0.7152 * linear(c.getGreen()) + 0.0722 * linear(c.getBlue());
    }

    private static double linear(int part) {
        double share = part / 255.0;
        return share <= 0.03928 ? share / 12.92 : StrictMath.pow((share + 0.055) / 1.055, 2.4);
    }

    /**
     * Returns a colour that a scene gives, changed towards that of text as little as makes it stand out from the floor
     * by a contrast of {@value #LEAST_CONTRAST}.
     */
    public Color readable(Color given) {
        Color shown = given;
        for (int k = 1; k <= 20 && contrast(shown, color(Tone.FLOOR)) < LEAST_CONTRAST; k++) {
            shown = Shapes.blend(given, color(Tone.TEXT), k / 20.0);
        }
        return shown;
    }

    /** Returns the colour of text on a fill: that of text or of ink, whichever stands out more. */
    public Color ink(Color fill) {
        Color text = color(Tone.TEXT);
        Color ink = color(Tone.INK);
        return contrast(text, fill) > contrast(ink, fill) ? text : ink;
    }

    /** Returns the colour of an ability. */
    public Color color(Ability ability) {
        return color(Tone.of(ability));
    }

    /**
     * Returns the line style of an ability: walk solid, sidestep solid and thin, stride in dashes and dots, vault dotted,
     * move dashed; {@code width} is that of the line in pixels, above 0.
     */
    public static BasicStroke stroke(Ability ability, float width) {
        return switch (ability) {
            case WALK -> line(width);
            case SIDESTEP -> line(width * 0.6f);
            case STRIDE -> line(width, 3.2f * width, 1.75f * width, 0.01f * width, 1.75f * width);
            case VAULT -> line(width, 0.01f * width, 2 * width);
            case MOVE -> line(width, 2.25f * width, 1.75f * width);
        };
    }

    /** Returns a line with round ends, dashed where dashes are given: lengths in pixels, on and off in turn. */
    public static BasicStroke line(float width, float... dashes) {
        return new BasicStroke(
                width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 10, dashes.length == 0 ? null : dashes, 0);
    }

    /** Returns the logical sans-serif font, which every JDK has, of the given size in pixels. */
    public static Font font(float size) {
        return new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(size);
    }

    /** Returns the bold logical sans-serif font of the given size in pixels. */
    public static Font bold(float size) {
        return new Font(Font.SANS_SERIF, Font.BOLD, 1).deriveFont(Font.BOLD, size);
    }
}
