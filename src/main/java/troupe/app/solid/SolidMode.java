package troupe.app.solid;

import java.util.Locale;

/** Where the view in three dimensions is shown. */
public enum SolidMode {
    /** Nowhere. */
    HIDDEN,
    /** In a corner of the plan, which leaves room for it. */
    INSET,
    /** At the side of the plan, as wide as it. */
    BESIDE,
    /** In place of the plan. */
    ALONE;

    /** Returns the word for it in settings and commands. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Finds one by its word, {@link #INSET} if there is none. */
    public static SolidMode of(String word) {
        for (SolidMode mode : values()) {
            if (mode.key().equals(word)) {
                return mode;
            }
        }
        return INSET;
    }
}
