package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Container;
import java.awt.Dimension;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import troupe.scene.Scene;

/** Looks for texts that are shortened or cut off, in small windows and at large scales, in both languages. */
class RoomRobotTest extends RobotTest {
    /** How many pixels at 100 % of a text may be cut off: rounding, and the overhang of letters. */
    private static final double SPARE = 1.5;

    private static final Pattern ENDS = Pattern.compile("(\\u2026|\\.\\.\\.)$");

    private final Map<String, Set<String>> found = new TreeMap<>();
    private int asked;
    private double scale;

    @Override
    void begin() {}

    private void open(int width, int height, int percent, Locale language) throws Exception {
        scale = percent / 100.0;
        studio = new StudioFixture(
                folder,
                Files.copy(Path.of(Studio.DEFAULT_SCENE), folder.resolve("courtyard.xml")),
                Map.of("language", language.toLanguageTag()));
        OnEventThread.run(() -> {
            studio.window().frame().setSize(new Dimension(width, height));
            studio.window().frame().validate();
            studio.window().scale(percent);
            studio.window().wantOutline(true);
        });
    }

    private void check(String stage, Container part) {
        for (PaintedTexts.Text text : PaintedTexts.of(part)) {
            asked++;
            boolean shortened = ENDS.matcher(text.words()).find();
            boolean cut = text.isSeen() && text.cut() > SPARE * scale;
            if ((shortened || cut) && !isMeant(text.words())) {
                String what = text.words() + (cut ? " cut by " + Math.round(text.cut()) : "");
                found.computeIfAbsent(what, k -> new TreeSet<>()).add(stage);
            }
        }
    }

    /**
     * Tells whether a text ends in dots because a dialog or more chips follow, or is one of the person's own, which
     * may be of any length: it can be read in full as a tool tip.
     */
    private boolean isMeant(String words) {
        String begin = ENDS.matcher(words).replaceAll("").strip();
        Scene scene = studio.session().document().scene();
        return begin.isEmpty()
                || scene.title().startsWith(begin)
                || scene.elements().anyMatch(element -> element.name().startsWith(begin))
                || words.startsWith(Path.of("").toAbsolutePath().toString())
                || studio.window().look().texts().under("").containsValue(words);
    }

    @ParameterizedTest
    @CsvSource({"1280,720,100,en", "2560,1440,200,zh-TW"})
    void nothingIsCutOff(int width, int height, int percent, String language) throws Exception {
        open(width, height, percent, Locale.forLanguageTag(language));
        new WindowStages(studio, this::check).walk();
        assertTrue(asked > 1_000, asked + " texts");
        assertEquals(Map.of(), found);
    }

    @ParameterizedTest
    @CsvSource({"2560,1440,200,en", "3840,2160,300,en", "3840,2160,300,zh-TW"})
    void nothingIsCutOffInTheWindowItself(int width, int height, int percent, String language) throws Exception {
        open(width, height, percent, Locale.forLanguageTag(language));
        OnEventThread.run(() -> {
            studio.window().frame().validate();
            check("window", studio.window().frame());
        });
        assertEquals(Map.of(), found);
    }
}
