package troupe.app.settings;

import java.util.Locale;

/** What the studio shows when it is started without a file. */
public enum Opening {
    /** The sample scene with its plan. */
    SAMPLE,
    /** The start page. */
    PAGE,
    /** The file that was opened last; the sample scene if it is gone. */
    LAST;

    /** Returns the word for it in settings and texts. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Finds one by its word, {@link #SAMPLE} if there is none. */
    static Opening of(String word) {
        for (Opening opening : values()) {
            if (opening.key().equals(word)) {
                return opening;
            }
        }
        return SAMPLE;
    }
}
