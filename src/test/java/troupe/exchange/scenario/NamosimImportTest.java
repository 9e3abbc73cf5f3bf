package troupe.exchange.scenario;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import troupe.exchange.Damage;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Reads drawings of NAMOSIM: both dialects by hand, wrong ones, and ten thousand damaged ones. */
class NamosimImportTest {
    private static final String SMALL = """
            <svg viewBox="0 0 400 200" xmlns="http://www.w3.org/2000/svg" xmlns:namo="namo">
              <namo_config cell_size_cm="5.0"><agent agent_id="robot"><goal goal_id="there"/></agent></namo_config>
              <path id="wall" type="wall" d="M 0,0 H 400 v 10 l -400,0 z"/>
              <path id="box" type="movable" d="m 100 50 40 0 0 40 h -40 z"/>
              <path id="robot" type="shape" d="M 40,100 60,80 80,100 60,120 Z"/>
              <path id="there" type="shape" d="M 290,90 h20 v20 h-20 z"/>
            </svg>
            """;

    private static Scene scene(String text) throws IOException, ExchangeException {
        return NamosimImport.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "small.svg");
    }

    @Test
    void turnsCentimetresDownIntoMetresUp() throws Exception {
        Scene scene = scene(SMALL);
        assertEquals(4, scene.world().width());
        assertEquals(2, scene.world().depth());
        assertEquals(0.05, scene.world().cell());
        Obstacle wall = scene.obstacle("wall").orElseThrow();
        assertEquals(Polygon.of(0, 2, 4, 2, 4, 1.9, 0, 1.9), wall.outline());
        assertFalse(wall.movable());
        assertEquals(3, wall.height());
        Obstacle box = scene.obstacle("box").orElseThrow();
        assertEquals(new Box(1, 1.1, 1.4, 1.5), box.outline().bounds());
        assertTrue(box.movable());
        assertTrue(box.height() < NamosimImport.BODY_HEIGHT && box.height() > NamosimImport.STEP_HEIGHT);
    }

    @Test
    void enclosesTheRobotInADiscAndMakesAJourney() throws Exception {
        Scene scene = scene(SMALL);
        Actor robot = scene.actor("robot").orElseThrow();
        assertEquals(0.2, robot.walk().radius(), 1e-12);
        assertEquals(0.1, robot.footRadius());
        assertEquals(Set.of(Ability.WALK, Ability.MOVE), robot.abilities());
        Journey journey = (Journey) scene.task("there").orElseThrow();
        assertNear(0.6, 1, journey.start());
        assertNear(3, 1, journey.goal());
        assertEquals("robot", journey.actor());
    }

    @Test
    void growsTheRobotByTheMarginThatIsGiven() throws Exception {
        String text = SMALL.replace("cell_size_cm=\"5.0\"", "collision_margin_cm=\"3\"");
        assertEquals(0.23, scene(text).actors().get(0).walk().radius(), 1e-12);
        assertEquals(4.0 / 256, scene(text).world().cell(), "the default cell where none is given");
    }

    @Test
    void takesRobotsAsGroupsAndTagsWithPrefixes() throws Exception {
        String grouped = SMALL.replace("svg ", "s:svg ")
                .replace("xmlns=\"", "xmlns:s=\"")
                .replace("</svg>", "</s:svg>")
                .replace("<path", "<s:path")
                .replace(
                        "<s:path id=\"robot\" type=\"shape\"",
                        "<s:g id=\"robot\"><s:path id=\"way\" type=\"orientation\" d=\"m 60,100 h 20\"/>"
                                + "<s:path id=\"hull\" type=\"shape\"")
                .replace("60,120 Z\"/>", "60,120 Z\"/></s:g>");
        assertEquals(scene(SMALL), scene(grouped));
    }

    @Test
    void leavesOutWhatIsNotDrawnOrOnlyDecoration() throws Exception {
        String more = SMALL.replace(
                "</svg>",
                "<defs><path id=\"a\" type=\"wall\" d=\"nonsense\"/></defs><path id=\"b\" d=\"M 0 0 A\"/>"
                        + "<path id=\"c\" namo:type=\"wall\" d=\"m 0,0 9,9 9,-9\"/><rect id=\"d\"/></svg>");
        assertEquals(scene(SMALL), scene(more));
    }

    @Test
    void makesAJourneyForEachGoalOfEachAgent() throws Exception {
        String two = SMALL.replace(
                "</agent>",
                "<goal goal_id=\"box\"/></agent><agent agent_id=\"there\"><goal goal_id=\"robot\"/></agent>");
        Scene scene = scene(two);
        assertEquals(
                List.of("robot-there", "robot-box", "there-robot"),
                scene.tasks().stream().map(t -> t.id()).toList());
        assertEquals(
                List.of("robot", "there"),
                scene.actors().stream().map(Actor::id).toList());
        assertNear(3, 1, ((Journey) scene.tasks().get(2)).start());
    }

    @Test
    void readsAViewBoxThatBeginsElsewhere() throws Exception {
        Scene shifted = scene(SMALL.replace("0 0 400 200", "-100,-50,600,300"));
        assertEquals(
                new Box(2, 1.6, 2.4, 2),
                shifted.obstacle("box").orElseThrow().outline().bounds());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "M1 2 3 4 5 0z | 1 2 3 4 5 0",
                "m1,2,3,4,5,0 | 1 2 4 6 9 6",
                "M.5.25-1-2e0L1e1+2 | .5 .25 -1 -2 10 2",
                "M0 0H5 3V2v1h-1Zz | 0 0 5 0 3 0 3 2 3 3 2 3",
                "M0 0 0 0 4 0 4 4 0 0 z | 0 0 4 0 4 4",
                "m 0 0 c 0 0 4 0 4 0 0 0 0 4 0 4 -1 0 -3 0 -4 0 | 0 0 4 0 4 4 0 4",
                "M 0 0 L 1 0 1e-5 1 | 0 0 1 0 1e-5 1"
            })
    void readsPathsInEveryForm(String text, String expected) throws Exception {
        double[] corners = List.of(expected.strip().split(" ")).stream()
                .mapToDouble(Double::parseDouble)
                .toArray();
        assertArrayEquals(corners, path(text), 1e-12);
    }

    private static double[] path(String text) throws ExchangeException {
        return PathData.read(text, (wrong, cure) -> new ExchangeException("path", 0, 0, wrong, cure));
    }

    @Test
    void cutsACurveThatLeavesItsChordWhereItEnds() throws Exception {
        double[] outline = path("M 0 4 H 4 c 1 0 -5 0 -3 0");
        assertTrue(outline.length > 6, "it turns back beyond both of its ends");
        assertEquals(1, outline[outline.length - 2], 1e-12);
    }

    @Test
    void flattensCurvesCloserThanATenthOfAMillimetre() throws Exception {
        Random random = new Random(11);
        for (int round = 0; round < 300; round++) {
            double[] p = random.doubles(8, -50, 50).toArray();
            double[] flat = path("M" + p[0] + " " + p[1] + "C" + p[2] + " " + p[3] + " " + p[4] + " " + p[5] + " "
                    + p[6] + " " + p[7]);
            for (int i = 0; i <= 400; i++) {
                double t = i / 400.0;
                double x = at(p[0], p[2], p[4], p[6], t);
                double y = at(p[1], p[3], p[5], p[7], t);
                assertTrue(fromChain(flat, x, y) <= PathData.FLATNESS + PathData.SAME, "round " + round + ", t " + t);
            }
        }
    }

    /** Returns a cubic's coordinate by de Casteljau's construction. */
    private static double at(double a, double b, double c, double d, double t) {
        double ab = a + t * (b - a);
        double bc = b + t * (c - b);
        double cd = c + t * (d - c);
        double abc = ab + t * (bc - ab);
        return abc + t * (bc + t * (cd - bc) - abc);
    }

    private static double fromChain(double[] chain, double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 2; i < chain.length; i += 2) {
            double dx = chain[i] - chain[i - 2];
            double dy = chain[i + 1] - chain[i - 1];
            double t = ((x - chain[i - 2]) * dx + (y - chain[i - 1]) * dy) / (dx * dx + dy * dy);
            double s = Math.max(0, Math.min(1, t));
            least = Math.min(least, Math.hypot(x - chain[i - 2] - s * dx, y - chain[i - 1] - s * dy));
        }
        return least;
    }

    @Test
    void saysInOneLineWhereADrawingIsWrongAndWhatToDo() {
        assertMessage(
                "small.svg:3: 'wall': command 'A' at character 7 of d; draw it with M L H V C Z alone",
                SMALL.replace("H 400 v", "A 400 v"));
        assertMessage(
                "small.svg:3: 'wall': found 'z' at character 26 of d; give a number",
                SMALL.replace("l -400,0 z", "l -400, z"));
        assertMessage(
                "small.svg:4: 'box': more than one outline, the second at character 28 of d;"
                        + " break the path apart; an obstacle has one outline without holes",
                SMALL.replace("h -40 z", "h -40 z M 9 9 z"));
        assertMessage(
                "small.svg:4: 'box': it is transformed, or a group around it is;"
                        + " apply the transform to the path's numbers",
                SMALL.replace("id=\"box\"", "id=\"box\" transform=\"scale(2)\""));
        assertMessage(
                "small.svg:4: 'box': the outline meets itself: its edges 2 and 4; move a corner of one of them",
                SMALL.replace("0 40 h -40", "-40 40 h 40"));
        assertMessage(
                "small.svg:4: 'box': type is 'moveable'; known are wall, movable, shape, orientation",
                SMALL.replace("movable", "moveable"));
        assertMessage(
                "small.svg:4: 'box': <rect> is no path; make a path of it",
                SMALL.replace("<path id=\"box\"", "<rect id=\"box\""));
        assertMessage(
                "small.svg:2: goal_id is 'where', and no path or group with a shape has that id; give it the id of one",
                SMALL.replace("goal_id=\"there\"", "goal_id=\"where\""));
        assertMessage(
                "small.svg: viewBox is ''; give viewBox='0 0 WIDTH HEIGHT' in centimetres",
                SMALL.replace("viewBox=\"0 0 400 200\"", ""));
        assertMessage("small.svg: cell_size_cm is 'x'; give a number from 0", SMALL.replace("5.0", "x"));
        assertMessage(
                "small.svg: no <goal> of an <agent> in a <namo_config>;"
                        + " name the robot and where it goes by the ids of their paths",
                SMALL.replace("namo_config", "desc").replace("<goal goal_id=\"there\"/>", ""));
    }

    @Test
    void refusesWhatIsNoDrawing() {
        assertMessage("small.svg:1: the file begins with <scene>; give an SVG drawing of NAMOSIM", "<scene/>");
        String bomb = "<!DOCTYPE svg [<!ENTITY a \"b\">]>" + SMALL;
        assertTrue(assertThrows(ExchangeException.class, () -> scene(bomb))
                .getMessage()
                .endsWith("take the document type out"));
        String cut = assertThrows(ExchangeException.class, () -> scene(SMALL.substring(0, 300)))
                .getMessage();
        assertTrue(cut.startsWith("small.svg:4:") && cut.endsWith("give a whole SVG file"), cut);
    }

    @Test
    void refusesMoreThanMemoryShouldHold() {
        assertThrows(ExchangeException.class, () -> path("M0 0C1e9 0 0 1e9 5 5"));
        assertThrows(ExchangeException.class, () -> path("M0 0" + "h1v1".repeat(5_001)));
        assertThrows(ExchangeException.class, () -> scene(SMALL.replace("</svg>", "<g>".repeat(80))));
        String curve = "<path id=\"c\" type=\"movable\" d=\"M0 0C5e5 0 0 5e5 5 5\"/>";
        assertThrows(ExchangeException.class, () -> scene(SMALL.replace("</svg>", curve.repeat(200) + "</svg>")));
    }

    @Test
    void isFoundByTheEndingOfTheFile() {
        assertEquals(
                "namosim", Formats.importerFor(Path.of("a.SVG")).orElseThrow().name());
    }

    @Test
    void tenThousandDamagedDrawingsGiveOnlyTheDeclaredException() throws Exception {
        long seed = Long.getLong("troupe.seed", 20_090_702L);
        Random random = new Random(seed);
        byte[] whole = SMALL.getBytes(StandardCharsets.UTF_8);
        int refused = 0;
        for (int round = 0; round < 10_000; round++) {
            try {
                Scene scene = NamosimImport.read(new ByteArrayInputStream(Damage.done(whole, random)), "bad.svg");
                if (round % 20 == 0) {
                    byte[] text = SceneXml.write(scene).getBytes(StandardCharsets.UTF_8);
                    assertEquals(
                            scene,
                            SceneXml.read(new ByteArrayInputStream(text), "again")
                                    .scene());
                }
            } catch (ExchangeException e) {
                assertFalse(e.getMessage().contains("\n"), () -> "seed " + seed + ": " + e.getMessage());
                refused++;
            }
        }
        assertTrue(refused > 5_000, "only " + refused + " of 10000 refused, seed " + seed);
    }

    private static void assertMessage(String message, String text) {
        assertEquals(
                message,
                assertThrows(ExchangeException.class, () -> scene(text)).getMessage());
    }

    private static void assertNear(double x, double y, Place place) {
        assertEquals(x, place.x(), 1e-12);
        assertEquals(y, place.y(), 1e-12);
    }
}
