package troupe.exchange.format;

import java.util.Locale;

/** Writes numbers with a decimal point in any locale, never with an exponent. */
public final class Decimals {
    private static final long MILLION = 1_000_000;
    private static final double EXACT = 4e9;

    private Decimals() {}

    /** Appends a finite number with six decimals, rounded to the nearest; never {@code -0.000000}. */
    public static StringBuilder six(StringBuilder out, double value) {
        if (!(Math.abs(value) < EXACT)) {
            return out.append(String.format(Locale.ROOT, "%.6f", value));
        }
        long rounded = Math.round(Math.abs(value) * MILLION);
        if (value < 0 && rounded > 0) {
            out.append('-');
        }
        out.append(rounded / MILLION).append('.');
        long rest = rounded % MILLION;
        for (long unit = MILLION / 10; unit > 1 && rest < unit; unit /= 10) {
            out.append('0');
        }
        return out.append(rest);
    }

    /** Returns a finite number with at most six decimals and no zeros at its end. */
    public static String trimmed(double value) {
        String text = six(new StringBuilder(), value).toString();
        int end = text.length();
        while (text.charAt(end - 1) == '0') {
            end--;
        }
        return text.substring(0, text.charAt(end - 1) == '.' ? end - 1 : end);
    }
}
