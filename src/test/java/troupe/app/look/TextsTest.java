package troupe.app.look;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class TextsTest {

    private static Properties load(String name) throws IOException {
        Properties properties = new Properties();
        try (Reader reader = new InputStreamReader(
                TextsTest.class.getResourceAsStream("/troupe/app/" + name), StandardCharsets.UTF_8)) {
            properties.load(reader);
        }
        return properties;
    }

    /** Shortcuts and icons are those of the English file. */
    private static Set<String> translated(Properties properties) {
        Set<String> keys = new TreeSet<>(properties.stringPropertyNames());
        keys.removeIf(k -> k.startsWith("command.") && (k.endsWith(".key") || k.endsWith(".icon")));
        return keys;
    }

    @Test
    void everyTextIsThereInEveryLanguage() throws IOException {
        Properties english = load("messages.properties");
        Properties chinese = load("messages_zh_TW.properties");
        assertEquals(translated(english), translated(chinese));
    }

    @Test
    void placeholdersAgree() throws IOException {
        Properties english = load("messages.properties");
        Properties chinese = load("messages_zh_TW.properties");
        for (String key : translated(english)) {
            int here = new MessageFormat(english.getProperty(key)).getFormats().length;
            int there = new MessageFormat(chinese.getProperty(key)).getFormats().length;
            assertEquals(here, there, key);
            assertFalse(english.getProperty(key).isBlank(), key);
            assertFalse(chinese.getProperty(key).isBlank(), key);
        }
    }

    @Test
    void everyExampleHasATitle() throws IOException {
        Properties english = load("messages.properties");
        try (Stream<Path> scenes = Files.walk(Path.of("scenes"))) {
            List<String> keys = scenes.filter(f -> f.toString().endsWith(".xml"))
                    .map(f -> "example." + f.getParent().getFileName() + "."
                            + f.getFileName().toString().replace(".xml", ""))
                    .filter(key -> !english.containsKey(key))
                    .toList();
            assertEquals(List.of(), keys);
        }
    }

    @Test
    void choosesTheLanguage() {
        assertEquals("檔案", new Texts(Locale.TAIWAN).get("menu.file"));
        assertEquals("檔案", new Texts(Locale.SIMPLIFIED_CHINESE).get("menu.file"));
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.TAIWAN);
            assertEquals("File", new Texts(Locale.ENGLISH).get("menu.file"));
            assertEquals("File", new Texts(Locale.GERMAN).get("menu.file"));
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void putsValuesInAsTheyPrint() {
        assertEquals("Move {x} 1234", new Texts(Locale.ENGLISH).format("edit.move", "{x} 1234"));
        assertEquals("1234567 labels expanded", new Texts(Locale.ENGLISH).format("status.expanded", 1234567));
    }

    @Test
    void printsNumbersAlikeEverywhere() {
        assertEquals("\u22121.50", Texts.number(-1.5, 2));
        assertEquals("0.0", Texts.number(-0.01, 1));
        assertEquals("1234.5", Texts.number(1234.5, 1));
        assertTrue(Texts.number(Double.NaN, 1).contains("NaN"));
    }
}
