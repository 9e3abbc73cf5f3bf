package troupe.app.look;

import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;

/** Gives every text of the studio in one language. Immutable; safe on any thread. */
public final class Texts {
    /** The languages there are texts for, the first for all others. */
    public static final List<Locale> LANGUAGES = List.of(Locale.ENGLISH, Locale.TRADITIONAL_CHINESE);

    private final Locale locale;
    private final ResourceBundle bundle;

    /** Loads the texts of a language; for one without texts, the English ones. */
    public Texts(Locale locale) {
        this.locale = closest(locale);
        this.bundle = ResourceBundle.getBundle("troupe.app.messages", this.locale, Texts.class.getClassLoader());
    }

    /** Returns the language of {@link #LANGUAGES} to use for a person with this locale. */
    public static Locale closest(Locale locale) {
        return locale.getLanguage().equals(Locale.CHINESE.getLanguage()) ? Locale.TRADITIONAL_CHINESE : Locale.ENGLISH;
    }

    /** Returns the language of these texts. */
    public Locale locale() {
        return locale;
    }

    /**
     * Returns the text of a key.
     *
     * @throws MissingResourceException if there is none
     */
    public String get(String key) {
        return bundle.getString(key);
    }

    /** Returns the text of a key, or {@code otherwise} if there is none. */
    public String get(String key, String otherwise) {
        return bundle.containsKey(key) ? bundle.getString(key) : otherwise;
    }

    /** Returns the text of a key with {@code {0}}, {@code {1}}, … replaced by values that are put in as they print. */
    public String format(String key, Object... values) {
        Object[] printed = new Object[values.length];
        for (int i = 0; i < values.length; i++) {
            printed[i] = String.valueOf(values[i]);
        }
        return new MessageFormat(get(key), Locale.ROOT).format(printed);
    }

    /** Returns a number with a fixed count of decimals and a true minus sign. */
    public static String number(double value, int decimals) {
        String printed = String.format(Locale.ROOT, "%." + decimals + "f", value);
        boolean negative = printed.startsWith("-");
        boolean zero = printed.chars().allMatch(c -> c == '-' || c == '0' || c == '.');
        return negative ? (zero ? "" : "\u2212") + printed.substring(1) : printed;
    }
}
