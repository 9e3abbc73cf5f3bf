package troupe.scene.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Numbers;
import troupe.scene.Obstacle;
import troupe.scene.Ordering;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.SceneTexts;
import troupe.scene.World;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;

class SceneXmlTest {

    private static String scene(String body) {
        return "<scene xmlns=\"urn:troupe:scene:1\">\n<world width=\"10\" depth=\"8\"/>\n" + body + "\n</scene>";
    }

    private static SceneException refused(String text) {
        return assertThrows(SceneException.class, () -> SceneTexts.read(text));
    }

    @ParameterizedTest
    @MethodSource("troupe.scene.SceneTexts#samples")
    void samplesAreInTheFormOfTheWriterAndFreeOfProblems(Path file) throws Exception {
        SceneSource source = SceneXml.read(file);
        assertEquals(Files.readString(file), SceneXml.write(source.scene()));
        assertEquals(List.of(), SceneChecks.check(source.scene(), source.lines()));
    }

    @Test
    void readsWhatItWroteWithEverySettingOffItsDefault() throws Exception {
        Actor standard = Actor.standard("a");
        Actor odd = new Actor(
                "a-1.b",
                "Ann \"the <tall> & 高\"\n",
                "#00ff7F",
                1.9,
                0.05,
                0.3,
                0.5,
                new Actor.Walk(0.3, 1.25, 1.5),
                Optional.empty(),
                Optional.of(new Actor.Stride(1, 1.1, 0.1 + 0.2, 1e-7, 2)),
                standard.vault(),
                Optional.empty());
        Scene scene = new Scene(
                "Title",
                new World(10, 8, 0.1),
                List.of(
                        new Obstacle("o", "", Polygon.of(0, 0, 1, 0, 0.1, 1 / 3.0), 0.5, 1, true, 3.5, "#112233"),
                        new Obstacle("p", "P", Polygon.rectangle(3, 3, 4, 4), 0, 2, false, 20, "")),
                List.of(new Ditch("d", "", Polygon.rectangle(5, 5, 6, 6), 1)),
                List.of(odd, standard),
                List.of(
                        Journey.of("j", "a", Place.of(1, 2), Place.of(3, 4, 0.5)),
                        new Journey(
                                "k",
                                "K",
                                "a",
                                Place.of(1, 2),
                                Place.of(3, 4),
                                Preferences.NEUTRAL
                                        .with(Ability.VAULT, Preferences.OFF)
                                        .with(Ability.WALK, 2),
                                new Ordering.Paper(2, 0.5),
                                Journey.Spread.CLEARANCE,
                                Journey.Manipulation.FREE,
                                360,
                                7,
                                99,
                                5,
                                -5),
                        Journey.of("l", "a", Place.of(1, 2), Place.of(3, 4)).with(new Ordering.Bounded(1.5))));
        String text = SceneXml.write(scene);
        assertEquals(scene, SceneTexts.read(text));
        assertEquals(text, SceneXml.write(SceneTexts.read(text)));
    }

    @Test
    void writesTheSameInAnyLocale() {
        Locale before = Locale.getDefault();
        Scene scene = new Scene("", new World(1.5, 2.5, 0.01), List.of(), List.of(), List.of(), List.of());
        String english = SceneXml.write(scene);
        try {
            Locale.setDefault(Locale.GERMANY);
            assertEquals(english, SceneXml.write(scene));
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void namesLineAndColumnOfAnUnknownElement() {
        SceneException e = refused(scene("<obstacles/>"));
        assertTrue(e.getMessage().startsWith("test.xml: line 3: column "), e.getMessage());
        assertTrue(e.getMessage().contains("obstacles"), e.getMessage());
        assertFalse(e.getMessage().contains("\n"));
    }

    @Test
    void namesEveryMistakeAtOnce() {
        SceneException e = refused(scene("<ditch id=\"d\" depth=\"deep\" points=\"0,0 1,1 1,0\"/>\n"
                + "<actor id=\"a\" bodyHeight=\"1,7\"><walk/></actor>\n"
                + "<journey id=\"j\" actor=\"a\" start=\"1\" goal=\"2,2\"/>"));
        assertEquals(3, e.problems().size(), e.problems().toString());
        assertEquals(List.of(3, 4, 5), e.problems().stream().map(Problem::line).toList());
        assertTrue(e.getMessage().endsWith("(and 2 more)"), e.getMessage());
    }

    @Test
    void namesTheAttributeAndWhatIsAllowed() {
        assertEquals(
                List.of(
                        "column 37: <ditch> lacks the attribute \"depth\"",
                        "column 37: <ditch> lacks the attribute \"points\""),
                refused(scene("<ditch id=\"d\" label=\"a ditch\"     />")).problems().stream()
                        .map(Problem::message)
                        .toList());
        String movable = refused(scene("<obstacle id=\"o\" height=\"1\" movable=\"maybe\" points=\"1,1 2,1 2,2\"/>"))
                .getMessage();
        assertTrue(
                movable.contains("<obstacle … movable=\"maybe\"> is not allowed; write true or false")
                        && !movable.contains("more)"),
                movable);
        for (String attribute : List.of("spread", "manipulation")) {
            SceneException e = refused(
                    scene("<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\" " + attribute + "=\"fast\"/>"));
            assertEquals(1, e.problems().size(), e.problems()::toString);
            assertTrue(
                    e.getMessage().contains("<journey … " + attribute + "=\"fast\"> is not allowed; write one of "),
                    e.getMessage());
        }
        String unknown = refused(scene("<well/>")).getMessage();
        assertTrue(
                unknown.contains("<well> does not belong here; write one of obstacle, ditch, actor, journey, enc"),
                unknown);
    }

    @Test
    void refusesWhatWouldTakeTooMuchBeforeItIsTaken() {
        String corners = "1,1 2,1 ".repeat(Numbers.MAX_CORNERS);
        assertTrue(refused(scene("<ditch id=\"d\" depth=\"1\" points=\"" + corners + "\"/>"))
                .getMessage()
                .contains("more than 10000 corners"));
        String ditch = "<ditch id=\"d\" depth=\"1\" points=\"" + "1,1 ".repeat(9_000) + "\"/>";
        assertTrue(refused(scene(ditch.repeat(60))).getMessage().contains("more than 500000 corners in all"));
        assertTrue(refused(scene("<ditch id=\"d\" depth=\"1\" points=\"1,1\"/>".repeat(100_001)))
                .getMessage()
                .contains("more than 100000 elements"));
        assertTrue(refused(scene("<actor id=\"a\">".repeat(80)))
                .problems()
                .toString()
                .contains("nested more than 64"));
        String number = "1".repeat(1_000_000);
        assertTrue(refused(scene("<ditch id=\"d\" depth=\"1\" points=\"" + number + ",x 1,2\"/>"))
                        .getMessage()
                        .length()
                < 500);
    }

    @Test
    void refusesDoctypesEntitiesAndOtherEncodingsOfHarm() {
        refused("<!DOCTYPE scene [<!ENTITY x SYSTEM \"file:///etc/passwd\">]>" + scene("&x;"));
        refused("");
        refused("not xml");
        refused("<scene xmlns=\"urn:troupe:scene:2\"/>");
        refused(scene("<obstacle id=\"o\" height=\"1\" points=\"\"/>"));
        refused(scene("<obstacle id=\"o\" height=\"1\" points=\"0,0 NaN,1 1,0\"/>"));
        refused(scene("<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\" slice=\"99999999999\"/>"));
        refused(scene("<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\"><prefer walk=\"-1\"/></journey>"));
        assertThrows(
                SceneException.class,
                () -> SceneXml.read(new ByteArrayInputStream(new byte[] {'<', (byte) 0xff, (byte) 0xfe}), "x"));
    }

    @Test
    void replacesAFileAsAWhole(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("scene.xml");
        Scene scene = new Scene("one", World.of(4, 3), List.of(), List.of(), List.of(), List.of());
        SceneXml.write(scene, file);
        SceneXml.write(new Scene("two", World.of(4, 3), List.of(), List.of(), List.of(), List.of()), file);
        assertEquals("two", SceneXml.read(file).scene().title());
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(1, files.count());
        }
    }

    @Test
    void followsALinkToTheFileItStandsFor(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("scene.xml");
        Files.writeString(file, "old");
        Path link = Files.createSymbolicLink(folder.resolve("link.xml"), file);
        Scene scene = new Scene("one", World.of(4, 3), List.of(), List.of(), List.of(), List.of());
        SceneXml.write(scene, link);
        assertTrue(Files.isSymbolicLink(link));
        assertEquals(scene, SceneXml.read(file).scene());
    }

    @Test
    void documentsTheSchemaThatItUses() throws IOException {
        assertEquals(
                Files.readString(Path.of("src/main/resources/troupe/scene/scene.xsd")),
                Files.readString(Path.of("docs/scene.xsd")));
    }

    @Test
    void theExampleOfTheManualIsASceneWithoutProblems() throws Exception {
        String manual = Files.readString(Path.of("docs/scene-format.md"));
        int from = manual.indexOf("```xml\n") + 7;
        Scene scene = SceneTexts.read(manual.substring(from, manual.indexOf("```", from)));
        assertEquals(List.of(), SceneChecks.check(scene));
        assertEquals(3, scene.obstacles().size());
    }
}
