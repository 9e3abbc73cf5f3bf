package troupe.scene.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.SceneTexts;
import troupe.scene.World;
import troupe.scene.xml.SceneXml;

class SceneChecksTest {

    private static List<Problem> problems(String body) throws Exception {
        return SceneChecks.check(SceneTexts.read(
                "<scene xmlns=\"urn:troupe:scene:1\">\n<world width=\"10\" depth=\"8\"/>\n" + body + "\n</scene>"));
    }

    private static void finds(Severity severity, String words, String body) throws Exception {
        List<Problem> found = problems(body);
        assertTrue(
                found.stream()
                        .anyMatch(p -> p.severity() == severity && p.message().contains(words)),
                () -> "no '" + words + "' in " + found);
        assertTrue(found.stream().noneMatch(p -> p.cure().isBlank()), found::toString);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "has 2 corners                 | 1,1 2,2",
                "no area                       | 1,1 2,2 3,3",
                "its edges 1 and 3             | 1,1 3,3 3,1 1,3",
                "its edges 1 and 2             | 1,1 5,1 3,1 3,4",
                "corners 2 and the next        | 1,1 2,1 2,1 2,3",
                "lies outside the world        | 11,1 12,1 12,3"
            })
    void namesABadOutline(String words, String points) throws Exception {
        finds(Severity.ERROR, words, "<obstacle id=\"o\" height=\"1\" points=\"" + points + "\"/>");
        finds(Severity.ERROR, words, "<ditch id=\"o\" depth=\"1\" points=\"" + points + "\"/>");
    }

    @Test
    void warnsOfWhatSticksOut() throws Exception {
        finds(Severity.WARNING, "sticks out", "<obstacle id=\"o\" height=\"1\" points=\"9,1 12,1 12,3\"/>");
    }

    @ParameterizedTest
    @CsvSource({"height,0", "height,NaN", "height,1e999", "offset,-1", "mass,0"})
    void namesANumberOutOfRange(String name, String value) throws Exception {
        String others = name.equals("height") ? "" : " height=\"1\"";
        finds(
                Severity.ERROR,
                name + " is ",
                "<obstacle id=\"o\"" + others + " " + name + "=\"" + value + "\" points=\"1,1 2,1 2,2\"/>");
    }

    @Test
    void warnsOfObstaclesInTheSameSpaceOnly() throws Exception {
        String lower = "<obstacle id=\"a\" height=\"1\" points=\"1,1 3,1 3,3 1,3\"/>";
        finds(
                Severity.WARNING,
                "same space as 'a'",
                lower + "<obstacle id=\"b\" height=\"1\" points=\"2,2 4,2 4,4\"/>");
        finds(
                Severity.WARNING,
                "same space as 'a'",
                lower + "<obstacle id=\"b\" height=\"1\" points=\"1,1 3,1 3,3 1,3\"/>");
        assertEquals(
                List.of(),
                problems(lower + "<obstacle id=\"on-top\" offset=\"1\" height=\"1\" points=\"1,1 3,1 3,3 1,3\"/>"
                        + "<obstacle id=\"beside\" height=\"1\" points=\"3,1 4,1 4,3 3,3\"/>"));
    }

    @Test
    void saysWhichOfTwoThatOverlapCannotBeMoved() throws Exception {
        String fixed = "<obstacle id=\"a\" height=\"1\" points=\"1,1 3,1 3,3 1,3\"/>";
        String crate = "<obstacle id=\"b\" height=\"1\" movable=\"true\" points=\"2,2 4,2 4,4\"/>";
        String box = "<obstacle id=\"c\" height=\"1\" movable=\"true\" points=\"3,2.5 5,2.5 5,3.5\"/>";
        finds(Severity.WARNING, "same space as 'a', so it cannot be moved", fixed + crate);
        finds(Severity.WARNING, "same space as 'b', so neither can be moved", crate + box);
    }

    @Test
    void stopsLookingForOverlapsInAHeapOfThousands() throws Exception {
        StringBuilder heap = new StringBuilder();
        for (int i = 0; i < 5_000; i++) {
            heap.append("<obstacle id=\"o").append(i).append("\" height=\"1\" points=\"1,1 5,1 5,5 1,5\"/>");
        }
        List<Problem> found = problems(heap.toString());
        assertEquals(101, found.size());
        finds(Severity.WARNING, "were not looked for", heap.toString());
    }

    @Test
    void namesLengthsThatNoGridCanTell() throws Exception {
        finds(Severity.ERROR, "not a place", "<obstacle id=\"o\" height=\"1\" points=\"1,1 1e300,2 2,1e300\"/>");
        finds(Severity.ERROR, "height is 1.0E8", "<obstacle id=\"o\" height=\"1e8\" points=\"1,1 3,2 2,3\"/>");
        for (String world : List.of(
                "width=\"1e300\" depth=\"1e300\" cell=\"1e299\"",
                "width=\"1e-9\" depth=\"1e-9\"",
                "width=\"1e300\" depth=\"1e300\" cell=\"1\"")) {
            List<Problem> found = SceneChecks.check(
                    SceneTexts.read("<scene xmlns=\"urn:troupe:scene:1\"><world " + world + "/></scene>"));
            assertTrue(found.stream().anyMatch(p -> p.severity() == Severity.ERROR), world);
        }
    }

    @Test
    void namesIdsThatAreWrongOrUsedTwice() throws Exception {
        finds(Severity.ERROR, "used twice", "<actor id=\"a\"><walk/></actor><actor id=\"a\"><walk/></actor>");
        finds(Severity.ERROR, "'1a' is not allowed", "<actor id=\"1a\"><walk/></actor>");
    }

    static Stream<String> badActors() {
        return Stream.of(
                "<actor id=\"a\" footRadius=\"0.3\"><walk/></actor>",
                "<actor id=\"a\"><walk/><sidestep radius=\"0.3\"/></actor>",
                "<actor id=\"a\" bodyHeight=\"0.4\"><walk/></actor>",
                "<actor id=\"a\"><walk speed=\"0\"/></actor>",
                "<actor id=\"a\"><walk speed=\"0.0099\"/></actor>",
                "<actor id=\"a\"><walk/><vault speed=\"0.001\"/></actor>",
                "<actor id=\"a\"><walk/><vault minHeight=\"0.2\"/></actor>",
                "<actor id=\"a\"><walk/><vault minHeight=\"1.2\"/></actor>",
                "<actor id=\"a\"><walk/><stride gait=\"800\"/></actor>",
                "<actor id=\"a\"><walk/><vault reach=\"11\"/></actor>",
                "<actor id=\"a\"><walk radius=\"NaN\"/></actor>");
    }

    @ParameterizedTest
    @org.junit.jupiter.params.provider.MethodSource("badActors")
    void namesAnActorThatCannotBe(String actor) throws Exception {
        List<Problem> found = problems(actor);
        assertEquals(
                List.of(Severity.ERROR),
                found.stream().map(Problem::severity).distinct().toList(),
                found::toString);
    }

    @Test
    void namesWhatAJourneyLacks() throws Exception {
        String actor = "<actor id=\"a\"><walk/></actor>";
        finds(Severity.ERROR, "no actor 'b'", actor + "<journey id=\"j\" actor=\"b\" start=\"1,1\" goal=\"2,2\"/>");
        finds(Severity.ERROR, "the goal", actor + "<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,9\"/>");
        finds(
                Severity.ERROR,
                "slice",
                actor + "<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\" slice=\"0\"/>");
        for (String headings : List.of("0", "-1", "361")) {
            finds(
                    Severity.ERROR,
                    "headings is " + headings,
                    actor + "<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\" headings=\"" + headings + "\"/>");
        }
        finds(
                Severity.ERROR,
                "walking is switched off",
                actor + "<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\"><prefer walk=\"off\"/></journey>");
    }

    @Test
    void refusesAGridThatDoesNotFitAndNamesACellThatDoes() throws Exception {
        Scene huge = SceneTexts.read("<scene xmlns=\"urn:troupe:scene:1\"><world width=\"1000\" depth=\"1000\""
                + " cell=\"0.0001\"/></scene>");
        List<Problem> found = SceneChecks.check(huge);
        assertEquals(1, found.size());
        assertTrue(found.get(0).cure().matches("a cell of .* m would fit"), found::toString);
    }

    @Test
    void listsTheWorstFirst() throws Exception {
        List<Problem> found = problems("<obstacle id=\"out\" height=\"1\" points=\"9,1 12,1 12,3\"/>"
                + "<obstacle id=\"bad\" height=\"0\" points=\"1,1 2,1 2,2\"/>");
        assertEquals(List.of("bad", "out"), found.stream().map(Problem::element).toList());
    }

    @Test
    void namesTextsThatNoFileCanHoldAndRefusesToWriteThem() {
        for (String title : List.of("a\u0001", "\uffff", "\ud800", "\udc00x")) {
            Scene scene = new Scene(title, World.of(4, 3), List.of(), List.of(), List.of(), List.of());
            assertEquals(1, SceneChecks.check(scene).size(), title);
            org.junit.jupiter.api.Assertions.assertThrows(IllegalArgumentException.class, () -> SceneXml.write(scene));
        }
        Scene fine = new Scene("\ud83d\ude00 \t高", World.of(4, 3), List.of(), List.of(), List.of(), List.of());
        assertEquals(List.of(), SceneChecks.check(fine));
        Obstacle red = new Obstacle("o", "", troupe.geometry.Polygon.rectangle(1, 1, 2, 2), 0, 1, false, 20, "red");
        Scene coloured = new Scene("", World.of(4, 3), List.of(red), List.of(), List.of(), List.of());
        assertTrue(SceneChecks.check(coloured).get(0).message().contains("'red'"));
    }

    @Test
    void namesCostsThatLieTooFarApart() throws Exception {
        String journey = "<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\">";
        String vaulter = "<actor id=\"a\"><walk energy=\"1e-7\"/><vault energy=\"1e6\"/></actor>";
        finds(Severity.ERROR, "times the cheapest", vaulter + journey + "</journey>");
        assertEquals(List.of(), problems(vaulter + journey + "<prefer vault=\"off\"/></journey>"));
        finds(
                Severity.ERROR,
                "times the cheapest",
                "<actor id=\"a\"><walk/><vault/></actor>" + journey + "<prefer vault=\"1e15\"/></journey>");
    }

    @Test
    void warnsOfMovableObstaclesThatCarrySomething() throws Exception {
        String crate = "<obstacle id=\"crate\" height=\"1\" movable=\"true\" points=\"1,1 3,1 3,3 1,3\"/>";
        String on = "\" height=\"0.1\" points=\"2,2 2.5,2 2.5,2.5 2,2.5\"/>";
        finds(Severity.WARNING, "carries 'book'", crate + "<obstacle id=\"book\" offset=\"1" + on);
        assertEquals(List.of(), problems(crate + "<obstacle id=\"lamp\" offset=\"1.2" + on));
        assertEquals(
                List.of(),
                problems(crate + "<obstacle id=\"beside\" offset=\"1\" height=\"1\" points=\"3,1 4,1 4,2 3,2\"/>"));
        assertEquals(List.of(), problems(crate.replace("true", "false") + "<obstacle id=\"book\" offset=\"1" + on));
    }

    @Test
    void boundsTheWorkOfAllOutlinesTogether() throws Exception {
        StringBuilder scene = new StringBuilder();
        for (int i = 0; i < 20; i++) {
            scene.append("<obstacle id=\"o")
                    .append(i)
                    .append("\" height=\"0.01\" offset=\"")
                    .append(i);
            scene.append("\" points=\"");
            for (int k = 0; k < 2_000; k++) {
                scene.append(1 + k * 0.001 + k % 2 * 4).append(k % 2 == 0 ? ",0.5 " : ",7.5 ");
            }
            scene.append("9.5,7.5 9.5,0.2 1,0.2\"/>");
        }
        List<Problem> found = problems(scene.toString());
        assertEquals(1, found.size(), found::toString);
        assertTrue(found.get(0).message().contains("not every outline was checked"), found::toString);
    }
}
