package troupe.unified.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/** Keeps scenes on which the planner was wrong once. */
class MovingMistakesTest {
    private static void compare(String elements) throws Exception {
        String text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<scene xmlns=\"urn:troupe:scene:1\">\n" + elements
                + "</scene>\n";
        Scene scene = SceneXml.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "mistake.xml")
                .scene();
        Journey journey = (Journey) scene.tasks().get(0);
        Answer answer = ExhaustivePlanner.solve(scene, journey);
        assertEquals(answer.cost(), MovingOracleTest.cost(scene, journey), 1e-6 * answer.cost(), answer.toString());
    }

    @Test
    void aPlaceBesideTwoObstaclesWaitsForTheWaysFromAllTriggersOfBoth() throws Exception {
        compare("""
                  <world width="3.651440538597688" depth="2.6279519205271478" cell="0.2"/>
                  <obstacle id="lower" height="2.4" points="1.9317110457838538,-0.1 2.1709907632339505,-0.1
                    2.1709907632339505,0.8810506783246381 1.9317110457838538,0.8810506783246381"/>
                  <obstacle id="upper" height="2.4" points="1.9317110457838538,1.5567986582209037
                    2.1709907632339505,1.5567986582209037 2.1709907632339505,2.727951920527148
                    1.9317110457838538,2.727951920527148"/>
                  <obstacle id="one" height="1.5" movable="true" mass="39.21424404372254"
                    points="2.3295649728393633,1.075363673849227
                    1.7403738098181851,1.4640732880457348 1.5422677149038413,1.03466438852319"/>
                  <obstacle id="two" height="1.5" movable="true" mass="14.211660507272493"
                    points="1.6398426834017872,0.9601065254249272
                    1.3853999776567687,1.1185189681743233 1.3390495297109204,0.8556709305389847"/>
                  <actor id="a" footRadius="0.08166259202454816" maxBorder="0.4761774591272787">
                    <walk radius="0.23307005450019927" energy="0.7092206589425547"/>
                    <stride gait="0.930270161352561" maxGap="0.7621777232031917" energy="1.030005461763106"
                      takeOff="1.2120135032019737"/>
                    <move energy="0.20832823430792247" turnEnergy="0.08497589707832066"/>
                  </actor>
                  <journey id="j" actor="a" start="0.9,2.3000000000000003,0" goal="3.1,1.5,0" manipulation="free"
                    headings="8"/>
                """);
    }
}
