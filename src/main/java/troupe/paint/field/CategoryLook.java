package troupe.paint.field;

import java.awt.Color;
import java.util.List;
import troupe.paint.Theme;
import troupe.paint.Tone;

/**
 * Gives each word of a field of categories a colour and a pattern, so that colour is never alone. Known
 * words keep their look everywhere; others take the next free one.
 */
public record CategoryLook(Color colour, Pattern pattern) {
    private static final int PERIOD = 8;
    private static final Pattern[] OTHER_PATTERNS = {
        Pattern.PLAIN, Pattern.RISING, Pattern.DOTS, Pattern.FALLING, Pattern.LEVEL, Pattern.UPRIGHT
    };
    private static final Tone[] OTHER_TONES = {Tone.WALK, Tone.VAULT, Tone.SIDESTEP, Tone.STRIDE, Tone.MOVE, Tone.DITCH
    };

    /** How the pixels of a category are set, by their place in tiles of eight pixels. */
    public enum Pattern {
        NONE,
        PLAIN,
        RISING,
        FALLING,
        DOTS,
        LEVEL,
        UPRIGHT,
        CROSSED;

        /** Returns how strongly pixel {@code (x, y)} is coloured, in [0, 1]. */
        double strength(int x, int y) {
            int column = x & PERIOD - 1;
            int row = y & PERIOD - 1;
            boolean set =
                    switch (this) {
                        case NONE -> false;
                        case PLAIN -> false;
                        case RISING -> (x + y & PERIOD - 1) < 2;
                        case FALLING -> (x - y & PERIOD - 1) < 2;
                        case DOTS -> column < 3 && row < 3 && column + row != 0 && column + row < 4;
                        case LEVEL -> row < 2;
                        case UPRIGHT -> column < 2;
                        case CROSSED -> (x + y & PERIOD - 1) < 1 || (x - y & PERIOD - 1) < 1;
                    };
            return this == NONE ? 0 : set ? 0.95 : 0.38;
        }
    }

    /** Returns the look of each word, in order. */
    public static CategoryLook[] of(List<String> words, Theme theme) {
        CategoryLook[] looks = new CategoryLook[words.size()];
        int next = 0;
        for (int i = 0; i < looks.length; i++) {
            looks[i] = known(words.get(i), theme);
            if (looks[i] == null) {
                looks[i] = new CategoryLook(
                        theme.color(OTHER_TONES[next % OTHER_TONES.length]),
                        OTHER_PATTERNS[(next + next / OTHER_PATTERNS.length) % OTHER_PATTERNS.length]);
                next++;
            }
        }
        return looks;
    }

    private static CategoryLook known(String word, Theme theme) {
        return switch (word) {
            case "stable", "walk", "reachable", "reached" -> new CategoryLook(theme.color(Tone.WALK), Pattern.PLAIN);
            case "bars-path" -> new CategoryLook(theme.color(Tone.DIM), Pattern.RISING);
            case "core" -> new CategoryLook(theme.color(Tone.DIM), Pattern.CROSSED);
            case "regrown" -> new CategoryLook(theme.color(Tone.STEP), Pattern.RISING);
            case "thin" -> new CategoryLook(theme.color(Tone.MOVE), Pattern.DOTS);
            case "border" -> new CategoryLook(theme.color(Tone.STEP), Pattern.LEVEL);
            case "sidestep" -> new CategoryLook(theme.color(Tone.SIDESTEP), Pattern.RISING);
            case "gap", "stride" -> new CategoryLook(theme.color(Tone.STRIDE), Pattern.DOTS);
            case "jumpable", "vault" -> new CategoryLook(theme.color(Tone.VAULT), Pattern.FALLING);
            case "forbidden", "unreachable", "unreached" -> new CategoryLook(theme.color(Tone.DIM), Pattern.CROSSED);
            case "absent", "none" -> new CategoryLook(theme.color(Tone.FLOOR), Pattern.NONE);
            default -> null;
        };
    }

    /** Returns the colour {@code 0xaarrggbb} of pixel {@code (x, y)}. */
    public int argb(int x, int y) {
        return (int) Math.round(255 * pattern.strength(x, y)) << 24 | colour.getRGB() & 0xffffff;
    }
}
