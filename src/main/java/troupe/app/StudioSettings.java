package troupe.app;

import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.BinaryOperator;
import java.util.prefs.Preferences;
import troupe.app.look.Texts;
import troupe.paint.Theme;

/** Remembers a person's choices from one start to the next: theme and language. */
final class StudioSettings {
    private static final String THEME = "theme";
    private static final String LANGUAGE = "language";

    private final BinaryOperator<String> read;
    private final BiConsumer<String, String> write;

    /** Makes settings over a store: {@code read} is given a key and a default, {@code write} a key and a value. */
    StudioSettings(BinaryOperator<String> read, BiConsumer<String, String> write) {
        this.read = read;
        this.write = write;
    }

    /** Returns the settings of the person who is logged in. */
    static StudioSettings ofPerson() {
        Preferences node = Preferences.userNodeForPackage(StudioSettings.class);
        return new StudioSettings(node::get, node::put);
    }

    /** Returns the theme; the light one if none was chosen. */
    Theme theme() {
        return read.apply(THEME, Theme.LIGHT.key()).equals(Theme.DARK.key()) ? Theme.DARK : Theme.LIGHT;
    }

    /** Remembers a theme. */
    void setTheme(Theme theme) {
        write.accept(THEME, theme.key());
    }

    /** Returns the language; that of the system if none was chosen. */
    Locale language() {
        return Texts.closest(
                Locale.forLanguageTag(read.apply(LANGUAGE, Locale.getDefault().toLanguageTag())));
    }

    /** Remembers a language. */
    void setLanguage(Locale language) {
        write.accept(LANGUAGE, language.toLanguageTag());
    }
}
