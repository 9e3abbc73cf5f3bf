package troupe.app.look;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tells sentences of the library in Chinese, and compares the patterns with what the library says today. */
class SentencesTest {
    private static final Texts CHINESE = new Texts(Locale.TRADITIONAL_CHINESE);
    private static final Pattern LITERAL = Pattern.compile("\"((?:[^\"\\\\]|\\\\.)*)\"");
    private static final Pattern VALUE = Pattern.compile("%[0-9.]*[a-zA-Z]|\\{\\d}|\\$\\d");
    private static final Pattern WORDS = Pattern.compile("[a-z]+ [a-z]+");
    private static final Path MAIN = Path.of("src/main/java/troupe");
    /** What reads files tells of arguments that come from them. */
    private static final List<Path> READING = List.of(MAIN.resolve("scene/xml"), MAIN.resolve("scene/Numbers.java"));

    /** Classes that say something to a person, besides those that read files and check scenes. */
    private static final List<String> SPEAKING = List.of(
            "SceneChecks",
            "SettingTable",
            "AvatarInspection",
            "SceneInspection",
            "Separation",
            "Standpoint",
            "EncounterEngine",
            "Spawning",
            "Numbers",
            "Orderings",
            "Settings",
            "CrowdSettings",
            "Failures",
            "ExportSettings",
            "GifExport",
            "ImageExport",
            "Instants",
            "MovingAiMap",
            "NamosimDrawing",
            "NamosimImport",
            "PathData",
            "PedestrianGround",
            "Places",
            "PngFile",
            "TextLines",
            "WalkableArea");

    private static String tell(String sentence) {
        return CHINESE.tell(sentence);
    }

    @Test
    void tellsSentencesWithTheirValues() {
        assertEquals("第 1 個角點與下一個重合", tell("corners 1 and the next are the same"));
        assertEquals("起點 8.1,5.5位於場景之外", tell("the start 8.1,5.5 lies outside the world"));
        assertEquals("起點 (8.1, 5.5)處沒有空間讓「ann」站立", tell("the start (8.1, 5.5) leaves actor 'ann' no room to stand"));
        assertEquals("化身「bob」：半徑為 -1", tell("avatar 'bob': radius is -1"));
        assertEquals(
                "從起點可到達 138.3 m²，但到不了終點；若沒有「Wall, south」或「Crate」，就有路可走",
                tell("no path: the start reaches 138.3 m², but not the goal; "
                        + "without 'Wall, south' or 'Crate', there is a way"));
        assertEquals(
                "從起點可到達 1.0 m²，但到不了終點；若沒有「A」，或若能翻越，就有路可走",
                tell(
                        "no path: the start reaches 1.0 m², but not the goal; without 'A', or with vault, there is a way"));
    }

    @Test
    void leavesWhatItDoesNotKnow() {
        assertEquals("something else went wrong", tell("something else went wrong"));
        assertEquals("C:\\a.xml: no such file", tell("C:\\a.xml: no such file"));
        assertEquals("a {0} of 'mine'", tell("a {0} of 'mine'"));
    }

    @Test
    void englishIsLeftAlone() {
        String sentence = "the start 8.1,5.5 lies outside the world";
        assertEquals(sentence, new Texts(Locale.ENGLISH).tell(sentence));
    }

    @Test
    void tellsASentenceBehindAFileAndALine() {
        assertEquals(
                "a.xml：第 3 行：多邊形沒有面積；請將一個角點移離直線",
                tell("a.xml: line 3: the polygon has no area; move a corner off the line"));
    }

    /** Returns the pieces of text between values that stand in the literals of some sources. */
    private static List<String> pieces(List<Path> sources) throws IOException {
        List<String> all = new ArrayList<>();
        for (Path source : sources) {
            boolean told =
                    source.endsWith("SettingTable.java") || READING.stream().anyMatch(source::startsWith);
            String thrown = told ? "IllegalState" : "Illegal(State|Argument)";
            String code = Files.readString(source)
                    .replaceAll("(?s)/\\*\\*.*?\\*/", "")
                    .replaceAll("(?s)String about\\(\\) \\{.*?}", "")
                    .replaceAll("(?s)new " + thrown + "Exception\\(.*?\\)+;", "")
                    .replaceAll("\"\\s*\\+\\s*\"", "");
            Matcher literal = LITERAL.matcher(code);
            while (literal.find()) {
                String text = literal.group(1).replace("\\\"", "\"");
                Stream.of(VALUE.split(text))
                        .flatMap(p -> Stream.of(p.split("[;:] ")))
                        .map(p -> bare(p).replaceAll("^\\W+|\\W+$", ""))
                        .filter(p -> !p.matches("\\w+ is"))
                        .filter(p -> WORDS.matcher(p).find() && !p.contains("=\"") && !p.startsWith("write "))
                        .forEach(all::add);
            }
        }
        return all;
    }

    private static String patterns() {
        Map<String, String> english = new Texts(Locale.ENGLISH).under(Sentences.PREFIX);
        return bare(String.join("\n", english.values()).replace("''", "'"));
    }

    /** Returns a text without values, numbers, and names that files use. */
    private static String bare(String text) {
        return text.replaceAll("\\{\\d}|\\d+|\\w+[a-z][A-Z]\\w*", "").replaceAll(" +", " ");
    }

    /** A sentence that was changed in the library and not here would be left in English. */
    @Test
    void everySentenceOfTheLibraryIsKnown() throws IOException {
        Pattern reading = Pattern.compile(".*/(scene/xml|run/file)/(?!.*(Writer|Journal|JournalRecord|Mistakes)).*");
        Pattern rules = Pattern.compile(".*/scene/check/\\w+Rules.java");
        List<String> names = new ArrayList<>(SPEAKING);
        List<Path> sources = new ArrayList<>();
        try (Stream<Path> all = Files.walk(MAIN)) {
            all.filter(f -> f.toString().endsWith(".java")).sorted().forEach(file -> {
                String name = file.getFileName().toString().replace(".java", "");
                String path = file.toString().replace('\\', '/');
                if (names.remove(name)
                        || reading.matcher(path).matches()
                        || rules.matcher(path).matches()) {
                    sources.add(file);
                }
            });
        }
        assertEquals(List.of(), names, "there is no such class");
        String known = patterns();
        List<String> pieces = pieces(sources);
        assertTrue(pieces.size() > 100, pieces.size() + " pieces");
        assertEquals(
                List.of(),
                pieces.stream().filter(piece -> !known.contains(piece)).toList());
    }
}
