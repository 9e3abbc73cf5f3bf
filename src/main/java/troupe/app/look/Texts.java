package troupe.app.look;

import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.MissingResourceException;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.TreeMap;

/** Gives every text of the studio in one language. Immutable; safe on any thread. */
public final class Texts {
    /** The languages there are texts for, the first for all others. */
    public static final List<Locale> LANGUAGES = List.of(Locale.ENGLISH, Locale.TRADITIONAL_CHINESE);

    private final Locale locale;
    private final ResourceBundle bundle;
    private final Optional<Sentences> sentences;

    /** Loads the texts of a language; for one without texts, the English ones. */
    public Texts(Locale locale) {
        this.locale = closest(locale);
        this.bundle = ResourceBundle.getBundle("troupe.app.messages", this.locale, Texts.class.getClassLoader());
        this.sentences = this.locale.equals(Locale.ENGLISH)
                ? Optional.empty()
                : Optional.of(new Sentences(english(), this::get, this::named));
    }

    private static Map<String, String> english() {
        ResourceBundle english =
                ResourceBundle.getBundle("troupe.app.messages", Locale.ENGLISH, Texts.class.getClassLoader());
        Map<String, String> patterns = new TreeMap<>();
        for (String key : english.keySet()) {
            if (key.startsWith(Sentences.PREFIX)) {
                patterns.put(key, english.getString(key));
            }
        }
        return patterns;
    }

    private Optional<String> named(String name) {
        String ability = "word." + name;
        return setting(name).or(() -> bundle.containsKey(ability) ? Optional.of(get(ability)) : Optional.empty());
    }

    /** Returns a sentence of the library, which speaks English, in this language; as it is where it is not known. */
    public String tell(String sentence) {
        return sentences.map(s -> s.tell(sentence)).orElse(sentence);
    }

    /**
     * Returns the word for a setting by its name in files ({@code walk.radius}, {@code ordering}), with that of the
     * group it belongs to; empty if there is none.
     */
    public Optional<String> setting(String name) {
        String key = "property.setting." + name;
        int dot = name.indexOf('.');
        String group = dot < 0 ? "" : "group.ability." + name.substring(0, dot);
        if (bundle.containsKey(key)) {
            return Optional.of(bundle.containsKey(group) ? get(group) + " \u2013 " + get(key) : get(key));
        }
        return bundle.containsKey("property." + name) ? Optional.of(get("property." + name)) : Optional.empty();
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

    /** Returns the texts of all keys that begin alike, by what follows that. */
    public Map<String, String> under(String prefix) {
        Map<String, String> all = new TreeMap<>();
        for (String key : bundle.keySet()) {
            if (key.startsWith(prefix)) {
                all.put(key.substring(prefix.length()), get(key));
            }
        }
        return all;
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
