package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Container;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Scene;

/** Looks for words in Latin letters in the Chinese window: none are left but names, units, keys and formats. */
class ChineseRobotTest extends RobotTest {
    private static final Pattern WORD = Pattern.compile("(?<![\\w#/.])[A-Za-z][A-Za-z'-]*");
    /** The rest of a word that had no room, the letter of a shortcut, a path. */
    private static final Pattern NO_WORDS = Pattern.compile("\\w*\u2026$|\\w*\\.\\.\\.$|\\+[A-Z]\\b|\\S*/\\S{3,}");

    private static final String NAMES = "Troupe Guy English PedPy Maya Blender JDK Java MovingAI NAMOSIM";
    private static final String KEYS = "Ctrl Shift Alt Esc Enter Escape Backspace Delete Home Page Up Down F";
    private static final String UNITS = "m cm kg s ms J x y z w rad GB px";
    private static final String FORMATS = "xml run gif png pngs csv svg map mel blender pedpy";
    /** Words of commands that the guide quotes. */
    private static final String COMMANDS = "java jar open my-scene";

    private static final Set<String> ALLOWED = Stream.of(NAMES, KEYS, UNITS, FORMATS, COMMANDS)
            .flatMap(words -> Stream.of(words.split(" ")))
            .collect(Collectors.toSet());

    private final Map<String, Set<String>> found = new TreeMap<>();
    private int asked;

    /** Adds the names of what a chooser of files lists and stands in, and what this Java calls itself. */
    private static void machine(Set<String> own) {
        for (String property : new String[] {"user.home", "java.vendor", "java.version", "os.name"}) {
            words(System.getProperty(property).replace('/', ' ')).forEach(own::add);
        }
        for (Path here = Path.of("").toAbsolutePath(); here != null; here = here.getParent()) {
            Stream.of(Objects.requireNonNullElse(here.toFile().list(), new String[0]))
                    .flatMap(ChineseRobotTest::words)
                    .forEach(own::add);
        }
    }

    @Override
    void begin() throws Exception {
        studio = new StudioFixture(
                folder,
                Files.copy(Path.of(Studio.DEFAULT_SCENE), folder.resolve("courtyard.xml")),
                Map.of("language", "zh-TW"));
    }

    private void check(String stage, Container part) {
        Scene scene = studio.session().document().scene();
        Set<String> own = new TreeSet<>(ALLOWED);
        machine(own);
        Stream.of(
                        scene.obstacles().stream().flatMap(o -> Stream.of(o.id(), o.label())),
                        scene.ditches().stream().flatMap(d -> Stream.of(d.id(), d.label())),
                        scene.actors().stream().flatMap(a -> Stream.of(a.id(), a.label())),
                        scene.tasks().stream().flatMap(t -> Stream.of(t.id(), t.label())),
                        scene.tasks().stream()
                                .filter(Encounter.class::isInstance)
                                .flatMap(t -> ((Encounter) t).avatars().stream())
                                .flatMap(a -> Stream.of(a.id(), a.label())),
                        scene.tasks().stream()
                                .filter(Crowd.class::isInstance)
                                .flatMap(t -> ((Crowd) t).allGroups())
                                .flatMap(g -> Stream.of(g.id(), g.label())),
                        Stream.of(scene.title(), folder.toString()))
                .flatMap(s -> s)
                .forEach(name -> words(name).forEach(own::add));
        studio.session().document().file().ifPresent(file -> words(file.toString())
                .forEach(own::add));
        Stream<String> painted = PaintedTexts.of(part).stream().map(PaintedTexts.Text::words);
        Stream.concat(painted, WindowStages.unpainted(part).stream()).forEach(text -> {
            asked++;
            words(text).filter(word -> !isKnown(word, own)).forEach(word -> found.computeIfAbsent(
                            text, k -> new TreeSet<>())
                    .add(stage));
        });
    }

    /** Tells whether a word is one of those that are allowed, or the beginning of one that had no room. */
    private static boolean isKnown(String word, Set<String> allowed) {
        String small = word.toLowerCase(Locale.ROOT);
        return allowed.stream()
                .map(name -> name.toLowerCase(Locale.ROOT))
                .anyMatch(name -> name.equals(small) || small.length() > 2 && name.startsWith(small));
    }

    private static Stream<String> words(String text) {
        Matcher matcher = WORD.matcher(NO_WORDS.matcher(text).replaceAll(""));
        return matcher.results().map(MatchResult::group);
    }

    @Test
    void noWordOfEnglishIsLeftInTheChineseWindow() throws Exception {
        new WindowStages(studio, this::check).walk();
        assertTrue(asked > 2_000, asked + " texts");
        assertEquals(Map.of(), found);
    }
}
