package troupe.cli.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.cli.Session;
import troupe.cli.Session.Result;

/** Explains a room with a low wall, worked out by hand in {@code ExplainerTest}. */
class ExplainCommandTest {
    private static final String SCENE = """
            <?xml version="1.0" encoding="UTF-8"?>
            <scene xmlns="urn:troupe:scene:1" title="Low wall">
              <world width="6" depth="6" cell="0.1"/>
              <obstacle id="wall" height="0.8" points="2.92,0 3.08,0 3.08,4.98 2.92,4.98"/>
              <actor id="ann"><walk/><vault/></actor>
              <journey id="across" actor="ann" start="1.05,1.05" goal="5.05,1.05"/>
            </scene>
            """;

    @TempDir
    Path folder;

    private Session session;
    private String scene;

    @BeforeEach
    void writeScene() throws IOException {
        session = new Session(folder);
        scene = Files.writeString(folder.resolve("wall.xml"), SCENE).toString();
    }

    @Test
    void tellsAPersonWhatWouldChangeThePlan() {
        Result result = session.run("explain", scene);
        assertEquals(0, result.code(), result.toString());
        assertEquals("", result.err());
        String[] lines = result.out().split("\n");
        assertEquals(6, lines.length, result.out());
        assertTrue(lines[0].startsWith("across: solved: walk, vault, walk; 4.00 m; energy 9.40 J"), lines[0]);
        assertEquals("  walk           3.30 J  cost     3.30", lines[1]);
        assertEquals("  vault          6.10 J  cost     6.10", lines[2]);
        assertEquals("without vault: walk; 10.47 m; energy 10.47 J; cost 10.47", lines[3]);
        assertEquals("walking only: walk; 10.47 m; energy 10.47 J; cost 10.47", lines[4]);
        assertEquals(
                "from preference.vault=1.175, 1.175 times as much: does without it, "
                        + "walk; 10.47 m; energy 10.47 J; cost 10.47",
                lines[5]);
    }

    @Test
    void printsOneObject() {
        Result result = session.run("explain", scene, "--set", "preference.vault=0.5", "--json");
        assertEquals(0, result.code(), result.toString());
        String json = result.out();
        assertEquals(1, json.lines().count());
        assertTrue(json.startsWith("{\"task\":\"across\",\"solved\":true,\"energy\":9.4"), json);
        assertTrue(json.contains("\"course\":[\"walk\",\"vault wall\",\"walk\"]"), json);
        assertTrue(
                json.contains("\"vault\":6.1},\"cost_by_ability\":{\"walk\":3.3000000000000003,\"vault\":3.05}"), json);
        assertTrue(json.contains("\"without\":[{\"abilities_off\":[\"vault\"],\"solved\":true"), json);
        assertTrue(json.contains("\"flips\":[{\"ability\":\"vault\",\"preference\":1.17"), json);
        assertTrue(json.contains("\"times\":2.34"), json);
        assertTrue(json.contains("\"given_up\":true,\"below\":{\"solved\":true"), json);
    }

    @Test
    void withoutAPlanItSaysWhy() throws IOException {
        Files.writeString(folder.resolve("wall.xml"), SCENE.replace("4.98", "6"));
        Result text = session.run("explain", scene, "--set", "preference.vault=off");
        assertEquals(1, text.code(), text.toString());
        assertTrue(text.out().startsWith("across: no solution: no path"), text.out());
        Result json = session.run("explain", scene, "--set", "preference.vault=off", "--json");
        assertEquals(1, json.code(), json.toString());
        assertTrue(json.out().startsWith("{\"task\":\"across\",\"solved\":false,\"reason\":\"no path"), json.out());
        Result none = session.run("explain", scene);
        assertEquals(0, none.code(), none.toString());
        assertTrue(none.out().contains("without vault: no way: no path"), none.out());
    }
}
