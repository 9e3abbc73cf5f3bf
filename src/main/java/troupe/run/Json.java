package troupe.run;

import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Writes values of a report as JSON text (RFC 8259): strings, truth values, finite numbers, lists and reports. */
public final class Json {
    private Json() {}

    /**
     * Returns the JSON text of a value, on one line.
     *
     * @throws IllegalArgumentException if the value is of a kind that a report cannot hold
     */
    public static String of(Object value) {
        StringBuilder out = new StringBuilder();
        write(value, out);
        return out.toString();
    }

    private static void write(Object value, StringBuilder out) {
        if (value instanceof String text) {
            string(text, out);
        } else if (value instanceof Report report) {
            object(report.values(), out);
        } else if (value instanceof List<?> list) {
            array(list, out);
        } else if (value instanceof Boolean
                || value instanceof Long
                || value instanceof Integer
                || value instanceof Double d && Double.isFinite(d)) {
            out.append(value);
        } else {
            throw new IllegalArgumentException(
                    value + " as JSON; needs text, a truth value, a finite number, a list or a report");
        }
    }

    private static void object(Map<String, Object> values, StringBuilder out) {
        out.append('{');
        String separator = "";
        for (Map.Entry<String, Object> entry : values.entrySet()) {
            out.append(separator);
            string(entry.getKey(), out);
            out.append(':');
            write(entry.getValue(), out);
            separator = ",";
        }
        out.append('}');
    }

    private static void array(List<?> list, StringBuilder out) {
        out.append('[');
        for (Iterator<?> i = list.iterator(); i.hasNext(); ) {
            write(i.next(), out);
            if (i.hasNext()) {
                out.append(',');
            }
        }
        out.append(']');
    }

    private static void string(String text, StringBuilder out) {
        out.append('"');
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            switch (c) {
                case '"' -> out.append("\\\"");
                case '\\' -> out.append("\\\\");
                case '\n' -> out.append("\\n");
                case '\r' -> out.append("\\r");
                case '\t' -> out.append("\\t");
                default -> {
                    if (c < 0x20 || lone(text, i)) {
                        out.append("\\u").append(String.format("%04x", (int) c));
                    } else {
                        out.append(c);
                    }
                }
            }
        }
        out.append('"');
    }

    /** Tells whether half of a surrogate pair stands alone, which no UTF-8 text can hold. */
    private static boolean lone(String text, int i) {
        char c = text.charAt(i);
        if (Character.isHighSurrogate(c)) {
            return i + 1 == text.length() || !Character.isLowSurrogate(text.charAt(i + 1));
        }
        return Character.isLowSurrogate(c) && (i == 0 || !Character.isHighSurrogate(text.charAt(i - 1)));
    }
}
