package troupe.app.panel;

import java.awt.FontMetrics;

/** Shortens texts that do not fit. */
final class Ellipsis {
    private Ellipsis() {}

    /** Returns the text, or its beginning with an ellipsis, at most {@code room} pixels wide if it can be. */
    static String fit(String text, FontMetrics metrics, int room) {
        if (metrics.stringWidth(text) <= room) {
            return text;
        }
        int end = text.length();
        while (end > 1 && metrics.stringWidth(text.substring(0, end) + "\u2026") > room) {
            end--;
        }
        return text.substring(0, end).stripTrailing() + "\u2026";
    }
}
