package troupe.scene.setting;

/** Writes texts as XML attribute values. */
public final class XmlText {
    private XmlText() {}

    /**
     * Appends a text so that it reads back equal from an attribute in double quotes.
     *
     * @throws IllegalArgumentException if it holds a character that XML 1.0 cannot
     */
    public static void escape(String text, StringBuilder out) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (!isXml(text, i)) {
                throw new IllegalArgumentException(
                        "character U+" + Integer.toHexString(c) + " in '" + text + "', which XML cannot hold");
            }
            switch (c) {
                case '&' -> out.append("&amp;");
                case '<' -> out.append("&lt;");
                case '>' -> out.append("&gt;");
                case '"' -> out.append("&quot;");
                case '\t', '\n', '\r' -> out.append("&#").append((int) c).append(';');
                default -> out.append(c);
            }
        }
    }

    /** Tells whether the character at {@code i} can stand in an XML 1.0 file, with its other half if it is one of two. */
    public static boolean isXml(String text, int i) {
        char c = text.charAt(i);
        if (Character.isHighSurrogate(c)) {
            return i + 1 < text.length() && Character.isLowSurrogate(text.charAt(i + 1));
        }
        if (Character.isLowSurrogate(c)) {
            return i > 0 && Character.isHighSurrogate(text.charAt(i - 1));
        }
        return c >= ' ' && c < '\ufffe' || c == '\t' || c == '\n' || c == '\r';
    }
}
