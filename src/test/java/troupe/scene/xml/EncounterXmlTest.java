package troupe.scene.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.SceneTexts;
import troupe.scene.World;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.setting.Settings;

/** Checks encounters in scene files: what is written reads back equal, and mistakes are named. */
class EncounterXmlTest {
    private static final Encounter ODD = new Encounter(
            "e",
            "Across",
            "w",
            Place.of(1, 1),
            Place.of(9, 7),
            List.of(
                    new Avatar(
                            "bob",
                            "Bob & Co",
                            "#102030",
                            0.3,
                            2,
                            0.5,
                            Avatar.Kind.CERTAIN,
                            new Avatar.Script(
                                    Place.of(2, 2),
                                    1.5,
                                    List.of(
                                            new Avatar.Head(Place.of(5, 5), OptionalDouble.empty()),
                                            new Avatar.Head(Place.of(2, 6), OptionalDouble.of(3.5))))),
                    Avatar.of("me", new Avatar.Pointer(Place.of(4, 4))),
                    Avatar.of("still", new Avatar.Script(Place.of(3, 3), Avatar.DEFAULT_PACE, List.of())),
                    Avatar.of(
                            "walker",
                            new Avatar.Script(
                                    Place.of(3, 3),
                                    Avatar.DEFAULT_PACE,
                                    List.of(new Avatar.Head(Place.of(5, 5), OptionalDouble.empty())))),
                    Avatar.of(
                            "p7",
                            new Avatar.Recording(List.of(new Avatar.Fix(-0.4, 1, 0.1), new Avatar.Fix(0, 1.5, 2))))),
            Encounter.Method.STATIC,
            Encounter.Order.OPTIMAL,
            Encounter.Influence.PAPER,
            Encounter.Growth.ROOT,
            Map.of(Encounter.Quantity.W1, -3.5, Encounter.Quantity.HORIZON, 2.5),
            -9);

    private static Scene scene(Encounter encounter) {
        return new Scene(
                "",
                new World(10, 8, 0.1),
                List.of(),
                List.of(),
                List.of(Actor.walker("w", 0.25, 0.1)),
                List.of(encounter));
    }

    private static String wrapped(String body) {
        return "<scene xmlns=\"urn:troupe:scene:1\">\n<world width=\"10\" depth=\"8\"/>\n<actor id=\"w\"/>\n"
                + "<encounter id=\"e\" actor=\"w\" start=\"1,1\" goal=\"9,7\">" + body + "</encounter>\n</scene>";
    }

    @Test
    void readsWhatItWrote() throws Exception {
        String text = SceneXml.write(scene(ODD));
        assertEquals(scene(ODD), SceneTexts.read(text));
        assertEquals(text, SceneXml.write(SceneTexts.read(text)));
        assertEquals(List.of(), SceneChecks.check(scene(ODD)));
    }

    @Test
    void everySettingChangesTheSceneAndSurvivesTheFile() throws Exception {
        Scene scene = scene(Encounter.of("e", "w", Place.of(1, 1), Place.of(9, 7), ODD.avatars()));
        Map<String, String> special = Map.of(
                "method",
                "once",
                "ordering",
                "optimal",
                "influence",
                "paper",
                "growth",
                "constant",
                "start",
                "3,4",
                "goal",
                "5,6",
                "cell",
                "0.2",
                "horizon",
                "7",
                "sigma",
                "0.5");
        for (String key : Settings.keys(ODD)) {
            String value = special.getOrDefault(key, "21");
            Scene changed = Settings.apply(scene, "e", key, value);
            assertTrue(!scene.equals(changed), key);
            assertEquals(changed, SceneTexts.read(SceneXml.write(changed)), key);
            assertEquals(value, Settings.values(changed, "e").get(key), key);
        }
        assertThrows(IllegalArgumentException.class, () -> Settings.apply(scene, "e", "history", "2.5"));
        assertThrows(IllegalArgumentException.class, () -> Settings.apply(scene, "e", "slice", "2"));
    }

    @Test
    void namesWhatIsWrongWithAnAvatar() throws Exception {
        for (String[] wrong : new String[][] {
            {"<avatar id=\"a\" start=\"1,1\"/><avatar id=\"a\" start=\"2,2\"/>", "used twice"},
            {"<avatar id=\"w\" start=\"1,1\"/>", "used twice"},
            {"<avatar id=\"a\" start=\"11,1\"/>", "outside the world"},
            {"<avatar id=\"a\"/>", "neither a start nor a track"},
            {"<avatar id=\"a\" start=\"1,1\" radius=\"0\"/>", "radius is 0"},
            {"<avatar id=\"a\" start=\"1,1\"><head to=\"2,2\" at=\"3\"/><head to=\"2,2\" at=\"2\"/></avatar>", "2 s"},
            {"<avatar id=\"a\"><track points=\"1,1,1 1,2,2\"/></avatar>", "not later"},
        }) {
            List<Problem> found = SceneChecks.check(SceneTexts.read(wrapped(wrong[0])));
            assertTrue(found.stream().anyMatch(p -> p.describe().contains(wrong[1])), wrong[0] + ": " + found);
        }
    }

    @Test
    void namesWhatCannotBeRead() {
        for (String[] wrong : new String[][] {
            {"<avatar id=\"a\" start=\"1\"/>", "x,y"},
            {"<avatar id=\"a\" start=\"1,1\"><track points=\"0,1,1\"/></avatar>", "cannot have a track"},
            {"<avatar id=\"a\"><head to=\"1,1\"/></avatar>", "goals and no start"},
            {"<avatar id=\"a\"><track points=\"0,1\"/></avatar>", "t,x,y"},
            {"<tracks file=\"x.csv\"/>", "no folder"},
            {"<avatar id=\"a\" start=\"1,1\" kind=\"odd\"/>", "kind"},
        }) {
            SceneException e = assertThrows(SceneException.class, () -> SceneTexts.read(wrapped(wrong[0])), wrong[0]);
            assertTrue(e.getMessage().contains(wrong[1]), wrong[0] + ": " + e.getMessage());
        }
    }

    @Test
    void readsTracksBesideTheScene(@TempDir Path folder) throws Exception {
        Files.writeString(
                folder.resolve("people.csv"), "# fps=10\nframe,id,x,y\n0,1,1,1\n5,1,1.5,1\n5,2,3,3\n10,2,3,3.5\n");
        Path file = folder.resolve("s.xml");
        Files.writeString(file, wrapped("<tracks file=\"people.csv\" begin=\"0.6\" radius=\"0.2\"/>"));
        Encounter read = (Encounter) SceneXml.read(file).scene().task("e").orElseThrow();
        assertEquals(1, read.avatars().size());
        Avatar avatar = read.avatars().get(0);
        assertEquals("p2", avatar.id());
        assertEquals(0.2, avatar.radius());
        Avatar.Fix last = ((Avatar.Recording) avatar.motion()).fixes().get(1);
        assertEquals(0.4, last.time(), 1e-12);
        for (String[] wrong : new String[][] {{"../people.csv", "plain name"}, {"none.csv", "cannot be read"}}) {
            Files.writeString(file, wrapped("<tracks file=\"" + wrong[0] + "\"/>"));
            SceneException e = assertThrows(SceneException.class, () -> SceneXml.read(file));
            assertTrue(e.getMessage().contains(wrong[1]), e.getMessage());
        }
        Files.writeString(folder.resolve("people.csv"), "# fps=10\n0,1,1,1\n0,1,2,2\n");
        Files.writeString(file, wrapped("<tracks file=\"people.csv\"/>"));
        SceneException e = assertThrows(SceneException.class, () -> SceneXml.read(file));
        assertTrue(e.getMessage().contains("line 3: person 1"), e.getMessage());
    }
}
