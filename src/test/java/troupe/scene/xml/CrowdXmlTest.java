package troupe.scene.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.setting.Settings;

class CrowdXmlTest {
    private static Crowd deep() {
        CrowdGroup.Members bodies =
                new CrowdGroup.Members(3, Polygon.rectangle(1, 1, 4, 4), OptionalDouble.of(2.5), 0.3, 1.1);
        CrowdGroup squad = new CrowdGroup("squad", "1st", "#112233", Optional.empty(), Optional.of(bodies), List.of());
        CrowdGroup other =
                CrowdGroup.of("other", Place.of(8, 8, 1), CrowdGroup.Members.of(2, Polygon.rectangle(5, 5, 9, 9)));
        CrowdGroup platoon = CrowdGroup.of("platoon", Place.of(2, 9), List.of(squad, other));
        CrowdGroup army = new CrowdGroup("army", "", "", Optional.empty(), Optional.empty(), List.of(platoon));
        return new Crowd(
                "march",
                "Going home",
                new Crowd.Manner(Crowd.Motion.PAPER, Crowd.Split.TREE, 3.5, 1.6, 0.2),
                new Crowd.Weights(1, 2, 3, 4, 5),
                List.of(new Crowd.Relation(0, 0.25, 0.5, 4), new Crowd.Relation(3, 2, 1.5, 0.5)),
                List.of(army),
                33,
                77);
    }

    private static Scene scene(Crowd crowd) {
        return new Scene("", new World(10, 10, 0.1), List.of(), List.of(), List.of(), List.of(crowd));
    }

    private static List<String> problems(Crowd crowd) {
        return SceneChecks.check(scene(crowd)).stream().map(Problem::message).toList();
    }

    @Test
    void readsWhatItWrote() throws SceneException, IOException {
        String text = SceneXml.write(scene(deep()));
        Scene read = SceneXml.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "test.xml")
                .scene();
        assertEquals(scene(deep()), read);
        assertEquals(List.of(), problems(deep()));
        assertEquals(3, deep().deepest());
    }

    @Test
    void everySettingTakesItsOwnValueAndRelationsHaveTheirDepths() {
        Scene scene = scene(deep());
        Scene same = scene;
        for (var entry : Settings.values(scene, "march").entrySet()) {
            same = Settings.apply(same, "march", entry.getKey(), entry.getValue());
        }
        assertEquals(Settings.values(scene, "march"), Settings.values(same, "march"));
        Crowd changed = (Crowd) Settings.apply(scene, "march", "relation.1.cohesion", "0.75")
                .task("march")
                .orElseThrow();
        assertEquals(0.75, changed.relation(1).cohesion());
        assertEquals(
                Crowd.defaultRelation(1, 3).separation(), changed.relation(1).separation());
        String unknown = assertThrows(
                        IllegalArgumentException.class,
                        () -> Settings.apply(scene, "march", "relation.4.cohesion", "1"))
                .getMessage();
        assertTrue(unknown.contains("relation.3.cohesion") && !unknown.contains("relation.4.cohesion,"), unknown);
    }

    @Test
    void closerRelativesCohereAndAlignMoreAndPushApartLess() {
        for (int depth = 1; depth <= 4; depth++) {
            Crowd.Relation far = Crowd.defaultRelation(depth - 1, 4);
            Crowd.Relation near = Crowd.defaultRelation(depth, 4);
            assertTrue(near.cohesion() > far.cohesion()
                    && near.alignment() > far.alignment()
                    && near.separation() < far.separation());
        }
        assertEquals(new Crowd.Relation(1, 1, 1, 1), Crowd.defaultRelation(1, 1));
    }

    @Test
    void namesWhatIsWrongWithATree() {
        CrowdGroup.Members bodies = CrowdGroup.Members.of(2, Polygon.rectangle(1, 1, 4, 4));
        CrowdGroup goalless = new CrowdGroup("lost", "", "", Optional.empty(), Optional.of(bodies), List.of());
        CrowdGroup twice = CrowdGroup.of("march", Place.of(2, 2), bodies);
        CrowdGroup empty = CrowdGroup.of("empty", Place.of(2, 2), List.of());
        List<String> found = problems(Crowd.of("march", List.of(goalless, twice, empty)));
        assertTrue(found.contains("the group has no goal"), found.toString());
        assertTrue(found.contains("the id is used twice"), found.toString());
        assertTrue(found.contains("the group has neither members nor parts"), found.toString());
    }

    @Test
    void namesNumbersOutOfRange() {
        CrowdGroup.Members bodies =
                new CrowdGroup.Members(0, Polygon.rectangle(1, 1, 4, 4), OptionalDouble.empty(), 0.05, 9);
        Crowd crowd = Crowd.of("march", List.of(CrowdGroup.of("g", Place.of(2, 20), bodies)))
                .with(new Crowd.Weights(-1, 0, 0, 0, Double.NaN))
                .lasting(0);
        List<String> found = problems(crowd);
        for (String part : List.of(
                "count is 0",
                "radius is 0.05",
                "speed is 9",
                "weights separation is -1",
                "weights anticipation is NaN",
                "seconds is 0",
                "lies outside the world")) {
            assertTrue(found.stream().anyMatch(m -> m.contains(part)), part + " in " + found);
        }
    }
}
