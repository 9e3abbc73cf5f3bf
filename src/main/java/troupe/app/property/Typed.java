package troupe.app.property;

import java.util.function.DoublePredicate;
import troupe.app.look.Texts;

/** Reads numbers as a person types them. Pure. */
final class Typed {
    static final DoublePredicate ANY = Double::isFinite;
    static final DoublePredicate POSITIVE = v -> Double.isFinite(v) && v > 0;
    static final DoublePredicate NOT_NEGATIVE = v -> Double.isFinite(v) && v >= 0;

    private Typed() {}

    /**
     * Reads a number; a decimal comma and a true minus sign are understood.
     *
     * @throws IllegalArgumentException if it is none, or not one that is allowed
     */
    static double number(String text, DoublePredicate allowed) {
        double value;
        try {
            value = Double.parseDouble(plain(text));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + text + "': a number is expected", e);
        }
        if (!allowed.test(value)) {
            throw new IllegalArgumentException(
                    text + (allowed == POSITIVE ? " \u2264 0" : allowed == NOT_NEGATIVE ? " < 0" : " ?"));
        }
        return value;
    }

    /** Returns a text with its minus signs and decimal commas as files have them. */
    static String plain(String text) {
        return text.strip().replace('\u2212', '-').replace(',', '.');
    }

    static String text(double value, int decimals) {
        return Texts.number(value, decimals);
    }
}
