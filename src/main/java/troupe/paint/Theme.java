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
